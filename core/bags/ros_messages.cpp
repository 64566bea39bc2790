#include "core/bags/ros_messages.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/phrase.h"
#include "core/recording/laser_scan.h"

namespace handmap::ros {

namespace {

constexpr double kFarthest_m = 1e8;
constexpr std::size_t kMostRays = 100'000;
constexpr std::size_t kMostPoints = 4'000'000;
constexpr std::uint32_t kMostPointBytes = 4096;
constexpr int kFloat32 = 7;
constexpr int kFloat64 = 8;

Eigen::Isometry3d poseIn(FieldReader& fields) {
  double v[7];
  for (int i = 0; i < 3; ++i) v[i] = fields.finite(kFarthest_m);
  for (int i = 3; i < 7; ++i) v[i] = fields.finite(2.0);
  Eigen::Quaterniond turn(v[6], v[3], v[4], v[5]);
  const double norm = turn.norm();
  if (norm < 0.7 || norm > 1.4) {
    fields.fail(phrase("a quaternion of length {:.3g}", norm), phrase("length 1"));
  }
  turn.normalize();
  return Eigen::Translation3d(v[0], v[1], v[2]) * turn;
}

std::string frameName(std::string name) {
  if (name.starts_with('/')) name.erase(0, 1);
  return name;
}

Points readScan(FieldReader fields, MessageEncoding encoding) {
  Points message;
  message.header = readHeader(fields, encoding);
  const auto bounded = [&](double low, double high) {
    const auto value = static_cast<double>(fields.get<float>());
    if (!(value >= low && value <= high)) {
      fields.fail(fmt::format("{}", value), phrase("a number from {} to {}", low, high));
    }
    return value;
  };
  LaserScan scan;
  scan.first_rad = bounded(-100.0, 100.0);
  bounded(-100.0, 100.0);  // the last direction
  scan.step_rad = bounded(-10.0, 10.0);
  const double between_s = bounded(0.0, 1.0);
  bounded(0.0, 1e9);  // from scan to scan
  scan.nearest_m = bounded(0.0, kFarthestPoint_m);
  const auto farthest = fields.get<float>();  // some say infinity
  scan.farthest_m = std::isfinite(farthest) ? farthest : kFarthestPoint_m;
  const std::size_t rays = fields.count(sizeof(float));
  if (rays > kMostRays) fields.fail(phrase("{} ranges", rays), phrase("at most {}", kMostRays));
  for (std::size_t i = 0; i < rays; ++i) scan.ranges.push_back(fields.get<float>());
  message.header.stamp_s += 0.5 * std::min(between_s * static_cast<double>(rays), 1.0);
  message.points = pointsOf(scan);
  message.reach_m = reachOf(scan);
  return message;
}

Points readCloud(FieldReader fields, MessageEncoding encoding) {
  Points message;
  message.header = readHeader(fields, encoding);
  PackedPoints packed;
  packed.rows = fields.get<std::uint32_t>();
  packed.columns = fields.get<std::uint32_t>();
  PackedField* const wanted[] = {&packed.x, &packed.y, &packed.z};
  int size[] = {0, 0, 0};
  for (std::size_t left = fields.count(13); left > 0; --left) {
    const std::string name = fields.text();
    const auto offset = fields.get<std::uint32_t>();
    const int type = fields.get<std::uint8_t>();
    fields.get<std::uint32_t>();  // how many
    for (int i = 0; i < 3; ++i) {
      if (name != std::string(1, static_cast<char>('x' + i))) continue;
      if (type != kFloat32 && type != kFloat64) {
        fields.fail(fmt::format("{}: {}", name, type),
                    phrase("{} or {}", "7 (float32)", "8 (float64)"));
      }
      *wanted[i] = {offset, type == kFloat64};
      size[i] = type == kFloat64 ? 8 : 4;
    }
  }
  packed.is_big_endian = fields.get<std::uint8_t>() != 0;
  packed.point_bytes = fields.get<std::uint32_t>();
  packed.row_bytes = fields.get<std::uint32_t>();
  packed.data = fields.takeSized<std::uint32_t>();
  const std::size_t points = packed.columns * packed.rows;  // of 32 bits each
  if (points > kMostPoints || packed.point_bytes > kMostPointBytes) {
    fields.fail(phrase("{} × {} bytes", points, packed.point_bytes),
                phrase("at most {} × {}", kMostPoints, kMostPointBytes));
  }
  for (int i = 0; i < 3; ++i) {
    const auto end = wanted[i]->offset + static_cast<std::size_t>(size[i]);
    if (size[i] == 0 || end > packed.point_bytes) {
      fields.fail(phrase("no field {}", std::string(1, static_cast<char>('x' + i))),
                  phrase("x, y and z"));
    }
  }
  if (points == 0) return message;
  const std::size_t line = packed.columns * packed.point_bytes;
  const std::size_t needed = packed.row_bytes * (packed.rows - 1) + line;
  if (packed.data.size() < needed || (packed.rows > 1 && packed.row_bytes < line)) {
    fields.fail(phrase("{} bytes", packed.data.size()), phrase("{} bytes", needed));
  }
  message.points = pointsOf(packed);
  return message;
}

}  // namespace

Header readHeader(FieldReader& fields, MessageEncoding encoding) {
  if (encoding == MessageEncoding::Ros1) fields.get<std::uint32_t>();  // its number
  Header header;
  header.stamp_s = fields.stamp();
  header.frame = frameName(fields.text());
  return header;
}

Pose readPose(FieldReader fields, const BagTopic& topic) {
  Pose message;
  message.header = readHeader(fields, topic.encoding);
  if (topic.type == "nav_msgs/Odometry") message.child = frameName(fields.text());
  message.pose = poseIn(fields);
  return message;
}

std::vector<Pose> readTransforms(FieldReader fields, const BagTopic& topic) {
  std::vector<Pose> transforms;
  for (std::size_t left = fields.count(60); left > 0; --left) {
    Pose transform;
    transform.header = readHeader(fields, topic.encoding);
    transform.child = frameName(fields.text());
    transform.pose = poseIn(fields);
    transforms.push_back(std::move(transform));
  }
  return transforms;
}

Points readPoints(FieldReader fields, const BagTopic& topic) {
  return isScan(topic) ? readScan(std::move(fields), topic.encoding)
                       : readCloud(std::move(fields), topic.encoding);
}

CameraInfo readCameraInfo(FieldReader fields, const BagTopic& topic) {
  constexpr std::uint32_t kMostPixels = 100'000;
  constexpr double kMost = 1e9;
  CameraInfo info;
  info.header = readHeader(fields, topic.encoding);
  const auto height = fields.get<std::uint32_t>();
  const auto width = fields.get<std::uint32_t>();
  if (height > kMostPixels || width > kMostPixels) {
    fields.fail(phrase("{} × {} pixels", width, height), phrase("at most {}", kMostPixels));
  }
  info.size = {static_cast<int>(width), static_cast<int>(height)};
  info.model = fields.text();
  const std::size_t coefficients = fields.count(8);
  if (coefficients > 14) fields.fail(phrase("{} numbers", coefficients), phrase("at most {}", 14));
  for (std::size_t i = 0; i < coefficients; ++i) info.distortion.push_back(fields.finite(kMost));
  for (double& value : info.matrix.val) value = fields.finite(kMost);
  for (double& value : info.rectification.val) value = fields.finite(kMost);
  for (double& value : info.projection.val) value = fields.finite(kMost);
  return info;
}

bool isPose(const BagTopic& topic) {
  return topic.type == "nav_msgs/Odometry" || topic.type == "geometry_msgs/PoseStamped" ||
         topic.type == "geometry_msgs/PoseWithCovarianceStamped";
}
bool isTransforms(const BagTopic& topic) {
  return topic.type == "tf2_msgs/TFMessage" || topic.type == "tf/tfMessage";
}
bool isImage(const BagTopic& topic) {
  return topic.type == "sensor_msgs/Image" || topic.type == "sensor_msgs/CompressedImage";
}
bool isScan(const BagTopic& topic) { return topic.type == "sensor_msgs/LaserScan"; }
bool isPointCloud(const BagTopic& topic) { return topic.type == "sensor_msgs/PointCloud2"; }
bool isCameraInfo(const BagTopic& topic) { return topic.type == "sensor_msgs/CameraInfo"; }

}  // namespace handmap::ros
