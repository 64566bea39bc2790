#include "drivers/emulators/ros_emulated_messages.h"

#include <QCborArray>
#include <cmath>
#include <cstring>

namespace handmap::emulated {

namespace {

constexpr auto kFloat32LittleEndian = static_cast<QCborTag>(85);
constexpr int kPointBytes = 16;

QCborMap object(std::initializer_list<std::pair<const char*, QCborValue>> members) {
  QCborMap result;
  for (const auto& [key, value] : members) result.insert(QLatin1String(key), value);
  return result;
}

QCborMap header(double stamp_s, RosVersion version) {
  const double seconds = std::floor(stamp_s);
  const auto nanoseconds = static_cast<qint64>((stamp_s - seconds) * 1e9);
  const bool ros1 = version == RosVersion::Ros1;
  const QCborMap stamp = object({{ros1 ? "secs" : "sec", static_cast<qint64>(seconds)},
                                 {ros1 ? "nsecs" : "nanosec", nanoseconds}});
  return object({{"stamp", stamp}, {"frame_id", QStringLiteral("base")}});
}

QCborMap triple(double x, double y, double z) { return object({{"x", x}, {"y", y}, {"z", z}}); }

}  // namespace

QCborMap odometry(double stamp_s, const Pose2& pose, RosVersion version) {
  QCborMap orientation = triple(0.0, 0.0, std::sin(0.5 * pose.heading));
  orientation.insert(QLatin1String("w"), std::cos(0.5 * pose.heading));
  const QCborMap inner =
      object({{"position", triple(pose.x, pose.y, 0.0)}, {"orientation", orientation}});
  return object({{"header", header(stamp_s, version)},
                 {"child_frame_id", QStringLiteral("base")},
                 {"pose", object({{"pose", inner}})}});
}

QCborMap laserScan(double stamp_s, const std::vector<float>& ranges, RosVersion version) {
  const QByteArray bytes(reinterpret_cast<const char*>(ranges.data()),
                         static_cast<qsizetype>(ranges.size() * sizeof(float)));
  return object({{"header", header(stamp_s, version)},
                 {"angle_min", -kPi},
                 {"angle_max", kPi},
                 {"angle_increment", 2.0 * kPi / static_cast<double>(ranges.size())},
                 {"time_increment", 0.0},
                 {"scan_time", 0.1},
                 {"range_min", 0.05},
                 {"range_max", 30.0},
                 {"ranges", QCborValue(kFloat32LittleEndian, bytes)}});
}

QCborMap pointCloud(double stamp_s, std::span<const RangePoint> points, RosVersion version) {
  QByteArray data;
  for (const RangePoint& point : points) {
    data.append(reinterpret_cast<const char*>(&point), kPointBytes);
  }
  QCborArray fields;
  for (int i = 0; i < 3; ++i) {
    fields.append(object({{"name", QString(QLatin1Char("xyz"[i]))},
                          {"offset", 4 * i},
                          {"datatype", 7},
                          {"count", 1}}));
  }
  const auto count = static_cast<qint64>(points.size());
  return object({{"header", header(stamp_s, version)},
                 {"height", 1},
                 {"width", count},
                 {"fields", fields},
                 {"is_bigendian", false},
                 {"point_step", kPointBytes},
                 {"row_step", count * kPointBytes},
                 {"data", data},
                 {"is_dense", true}});
}

QCborMap compressedImage(double stamp_s, const QByteArray& file, RosVersion version) {
  return object(
      {{"header", header(stamp_s, version)}, {"format", QStringLiteral("png")}, {"data", file}});
}

QCborMap image(double stamp_s, const cv::Mat& grey, RosVersion version) {
  const QByteArray data(reinterpret_cast<const char*>(grey.data), grey.rows * grey.cols);
  return object({{"header", header(stamp_s, version)},
                 {"height", grey.rows},
                 {"width", grey.cols},
                 {"encoding", QStringLiteral("mono8")},
                 {"is_bigendian", 0},
                 {"step", grey.cols},
                 {"data", data}});
}

QCborMap cameraInfo(const cv::Size& size, const StereoCamera& camera, double baseline,
                    RosVersion version) {
  const auto list = [](std::initializer_list<double> numbers) {
    QCborArray array;
    for (const double number : numbers) array.append(number);
    return array;
  };
  const auto& [fx, fy, cx, cy, its_own, mount] = camera;
  const bool ros1 = version == RosVersion::Ros1;
  return object({{"header", header(0.0, version)},
                 {"height", size.height},
                 {"width", size.width},
                 {"distortion_model", QStringLiteral("plumb_bob")},
                 {ros1 ? "D" : "d", list({0, 0, 0, 0, 0})},
                 {ros1 ? "K" : "k", list({fx, 0, cx, 0, fy, cy, 0, 0, 1})},
                 {ros1 ? "R" : "r", list({1, 0, 0, 0, 1, 0, 0, 0, 1})},
                 {ros1 ? "P" : "p", list({fx, 0, cx, -fx * baseline, 0, fy, cy, 0, 0, 0, 1, 0})}});
}

}  // namespace handmap::emulated
