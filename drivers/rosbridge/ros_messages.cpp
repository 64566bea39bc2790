#include "drivers/rosbridge/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/bags/ros_messages.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"
#include "core/recording/laser_scan.h"

namespace handmap {

namespace {

constexpr double kFarthest_m = 1e7;
constexpr double kFarthestPoint_m = 1e4;
constexpr std::size_t kMostRays = 100'000;
constexpr std::int64_t kMostPoints = 2'000'000;
constexpr std::int64_t kMostPointBytes = 1024;
constexpr std::size_t kMostBytes = 32 << 20;
constexpr std::size_t kMostName = 300;  // bytes
constexpr std::int64_t kFloat32 = 7;
constexpr std::int64_t kFloat64 = 8;

double stampOf(const RosValue& message) {
  const RosValue stamp = message.at("header").at("stamp");
  const bool ros1 = stamp.find("secs").has_value();
  const double seconds = stamp.at(ros1 ? "secs" : "sec").number(-2147483648.0, 4294967295.0);
  return seconds + 1e-9 * stamp.at(ros1 ? "nsecs" : "nanosec").number(0.0, 4294967295.0);
}

double yawOf(const RosValue& orientation) {
  const auto part = [&](const char* key) { return orientation.at(key).number(-2.0, 2.0); };
  const double x = part("x");
  const double y = part("y");
  const double z = part("z");
  const double w = part("w");
  const double norm = x * x + y * y + z * z + w * w;
  if (norm < 0.5 || norm > 2.0) {
    orientation.fail(phrase("no rotation"), phrase("a quaternion of length 1"));
  }
  return std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

/// Of nav_msgs/Odometry and geometry_msgs/PoseWithCovarianceStamped.
Pose2 planarPose(const RosValue& message) {
  const RosValue pose = message.at("pose").at("pose");
  const RosValue position = pose.at("position");
  return {position.at("x").number(-kFarthest_m, kFarthest_m),
          position.at("y").number(-kFarthest_m, kFarthest_m), yawOf(pose.at("orientation"))};
}

/// ROS 1 may write them with a slash that tf2 does not know.
std::string frameName(std::string name) {
  if (name.starts_with('/')) name.erase(0, 1);
  return name;
}

std::string frameOf(const RosValue& message) {
  const auto frame = message.at("header").find("frame_id");
  return frame ? frameName(frame->text(kMostName)) : std::string();
}

PackedField fieldOf(const RosValue& message, const std::string& name, std::int64_t point_bytes) {
  const RosValue fields = message.at("fields");
  for (const RosValue& field : fields.items(100)) {
    if (field.at("name").text(200) != name) continue;
    const std::int64_t type = field.at("datatype").integer(0, 255);
    if (type != kFloat32 && type != kFloat64) {
      field.at("datatype")
          .fail(fmt::format("{}", type), phrase("{} or {}", "7 (float32)", "8 (float64)"));
    }
    const std::int64_t size = type == kFloat32 ? 4 : 8;
    return {static_cast<std::size_t>(field.at("offset").integer(0, point_bytes - size)),
            type == kFloat64};
  }
  fields.fail(phrase("no field {}", name), phrase("x, y and z"));
}

}  // namespace

RosOdometryMessage readOdometry(const RosValue& message) {
  const auto base = message.find("child_frame_id");
  return {stampOf(message), planarPose(message), frameOf(message),
          base ? frameName(base->text(kMostName)) : std::string()};
}

RosPoseMessage readPose(const RosValue& message) { return {planarPose(message), frameOf(message)}; }

RosPointsMessage readLaserScan(const RosValue& message) {
  LaserScan scan;
  scan.first_rad = message.at("angle_min").number(-100.0, 100.0);
  scan.step_rad = message.at("angle_increment").number(-1.0, 1.0);
  const double between_s = message.at("time_increment").number(0.0, 1.0);
  scan.nearest_m = message.at("range_min").number(0.0, kFarthestPoint_m);
  scan.farthest_m = message.at("range_max").number(0.0, 1e9);
  scan.ranges = message.at("ranges").numbers(kMostRays);
  const auto rays = static_cast<double>(scan.ranges.size());
  return {stampOf(message) + 0.5 * std::min(between_s * rays, 1.0), pointsOf(scan), reachOf(scan)};
}

RosPointsMessage readPointCloud(const RosValue& message) {
  const std::int64_t width = message.at("width").integer(0, kMostPoints);
  const std::int64_t height = message.at("height").integer(0, kMostPoints);
  if (width * height > kMostPoints) {
    message.at("width").fail(phrase("{} × {} points", width, height),
                             phrase("at most {}", kMostPoints));
  }
  const std::int64_t step = message.at("point_step").integer(1, kMostPointBytes);
  const std::int64_t row = message.at("row_step").integer(width * step, std::int64_t{kMostBytes});
  const bool big = message.at("is_bigendian").flag();
  const PackedField x = fieldOf(message, "x", step);
  const PackedField y = fieldOf(message, "y", step);
  const PackedField z = fieldOf(message, "z", step);
  const QByteArray data = message.at("data").bytes(kMostBytes);
  const std::int64_t needed = height == 0 ? 0 : row * (height - 1) + width * step;
  if (data.size() < needed) {
    message.at("data").fail(phrase("{} bytes", data.size()), fmt::format("{}", needed));
  }
  const auto size = [](std::int64_t count) { return static_cast<std::size_t>(count); };
  const PackedPoints packed{size(width),
                            size(height),
                            size(step),
                            size(row),
                            big,
                            x,
                            y,
                            z,
                            {data.constData(), size(data.size())}};
  return {stampOf(message), pointsOf(packed)};
}

RosImageMessage readImage(const RosValue& message) {
  const QByteArray data = message.at("data").bytes(kMostBytes);
  const std::string_view bytes(data.constData(), static_cast<std::size_t>(data.size()));
  const std::string source = phrase("image over ROS");
  const auto encoding = message.find("encoding");
  if (!encoding) return {stampOf(message), decodeImage(bytes, source)};
  const auto count = [&](const char* key) {
    return static_cast<std::uint32_t>(message.at(key).integer(0, 0xffffffff));
  };
  return {stampOf(message),
          ros::imageOf({count("height"), count("width"), encoding->text(100), count("step"), bytes},
                       source)};
}

}  // namespace handmap
