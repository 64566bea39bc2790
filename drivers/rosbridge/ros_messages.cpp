#include "drivers/rosbridge/ros_messages.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/phrase.h"
#include "core/recording/image_file.h"
#include "core/recording/laser_scan.h"

namespace handmap {

namespace {

constexpr double kFarthest_m = 1e7;
constexpr std::size_t kMostRays = 100'000;
constexpr std::int64_t kMostPoints = 2'000'000;
constexpr std::int64_t kMostPointBytes = 1024;
constexpr std::size_t kMostBytes = 32 << 20;
constexpr std::size_t kMostName = 300;       // bytes
constexpr std::int64_t kMostSide = 100'000;  // pixels
constexpr std::size_t kMostDistortion = 14;  // OpenCV knows no more
constexpr double kLargestOfCamera = 1e9;
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

/// D, K, R and P of a CameraInfo: ROS 2 writes them small.
std::vector<double> calibrationOf(const RosValue& message, const char* ros2, const char* ros1,
                                  std::size_t least, std::size_t most) {
  const RosValue list = message.at(message.find(ros1) ? ros1 : ros2);
  std::vector<double> numbers = list.numbers(most);
  if (numbers.size() < least) {
    list.fail(phrase("{} values", numbers.size()), fmt::format("{}", least));
  }
  for (const double number : numbers) {
    if (std::abs(number) <= kLargestOfCamera) continue;
    list.fail(fmt::format("{:g}", number),
              phrase("a number from {:g} to {:g}", -kLargestOfCamera, kLargestOfCamera));
  }
  return numbers;
}

template <int rows, int columns>
void readMatrix(const RosValue& message, const char* ros2, const char* ros1,
                cv::Matx<double, rows, columns>& matrix) {
  constexpr std::size_t kCount = std::size_t{rows} * columns;
  const std::vector<double> numbers = calibrationOf(message, ros2, ros1, kCount, kCount);
  std::copy(numbers.begin(), numbers.end(), matrix.val);
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

ros::CameraInfo readCameraInfo(const RosValue& message) {
  ros::CameraInfo info;
  info.size = {static_cast<int>(message.at("width").integer(0, kMostSide)),
               static_cast<int>(message.at("height").integer(0, kMostSide))};
  info.model = message.at("distortion_model").text(kMostName);
  info.distortion = calibrationOf(message, "d", "D", 0, kMostDistortion);
  readMatrix(message, "k", "K", info.matrix);
  readMatrix(message, "r", "R", info.rectification);
  readMatrix(message, "p", "P", info.projection);
  return info;
}

}  // namespace handmap
