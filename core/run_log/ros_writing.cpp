#include "core/run_log/ros_writing.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgcodecs.hpp>

#include "core/bags/field_writer.h"

namespace handmap::ros {

namespace {

constexpr double kOutlineStep_m = 0.2;
constexpr std::uint8_t kFloat32 = 7;

FieldWriter stamped(const Stamp& stamp) {
  FieldWriter to = FieldWriter::cdr();
  to.stamp(stamp.time_s);
  to.text(stamp.frame);
  return to;
}

void put(FieldWriter& to, std::initializer_list<double> values) {
  for (const double value : values) to.put(value);
}

/// Position (or translation) and rotation.
void putPose(FieldWriter& to, const Pose2& pose) {
  put(to,
      {pose.x, pose.y, 0.0, 0.0, 0.0, std::sin(pose.heading / 2.0), std::cos(pose.heading / 2.0)});
}

/// Of x y z roll pitch yaw, row by row.
void putCovariance(FieldWriter& to, const FrameReport* report) {
  double covariance[36] = {};
  if (report != nullptr) {
    covariance[0] = report->pose_sigma[0] * report->pose_sigma[0];
    covariance[7] = report->pose_sigma[1] * report->pose_sigma[1];
    covariance[1] = covariance[6] = report->pose_xy;
    covariance[35] = report->pose_sigma[2] * report->pose_sigma[2];
  }
  for (const double value : covariance) to.put(value);
}

void putBytes(FieldWriter& to, std::string_view bytes) { to.sized<std::uint32_t>(bytes); }

/// Rows of float32: x y z and, with four, intensity.
std::string cloud(const Stamp& stamp, const std::vector<float>& values, std::size_t columns) {
  constexpr const char* kNames[] = {"x", "y", "z", "intensity"};
  const std::size_t points = values.size() / columns;
  const auto point_bytes = static_cast<std::uint32_t>(columns * sizeof(float));
  FieldWriter to = stamped(stamp);
  to.put(std::uint32_t{1});
  to.count(points);
  to.count(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    to.text(kNames[i]);
    to.put(static_cast<std::uint32_t>(i * sizeof(float)));
    to.put(kFloat32);
    to.put(std::uint32_t{1});
  }
  to.put(std::uint8_t{0});
  to.put(point_bytes);
  to.put(static_cast<std::uint32_t>(points * point_bytes));
  putBytes(to, {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
  to.put(std::uint8_t{1});
  return to.bytes();
}

struct Colour {
  float r, g, b, a;
};

void putColour(FieldWriter& to, const Colour& colour) {
  for (const float part : {colour.r, colour.g, colour.b, colour.a}) to.put(part);
}

/// What markers have in common; `points` of a line, or a text.
void putMarker(FieldWriter& to, const Stamp& stamp, int number, int type, const Pose2& pose,
               double size, const Colour& colour, const Polygon& points, std::string_view text) {
  to.stamp(stamp.time_s);
  to.text(stamp.frame);
  to.text("buildings");
  to.put(static_cast<std::int32_t>(number));
  to.put(static_cast<std::int32_t>(type));
  to.put(std::int32_t{0});  // add
  putPose(to, pose);
  put(to, {size, size, size});
  putColour(to, colour);
  to.put(std::int32_t{0});  // for ever
  to.put(std::uint32_t{0});
  to.put(std::uint8_t{0});
  to.count(points.size());
  for (const Vec2& point : points) put(to, {point.x(), point.y(), 0.0});
  to.count(0);  // colours
  to.text("");  // a texture: none
  to.stamp(0.0);
  to.text("");
  to.text("");
  to.count(0);
  to.count(0);
  to.text(text);
  to.text("");  // a mesh: none
  to.text("");
  to.count(0);
  to.put(std::uint8_t{0});
}

}  // namespace

std::string transform(const Stamp& stamp, std::string_view child, const Pose2& pose) {
  FieldWriter to = FieldWriter::cdr();
  to.count(1);
  to.stamp(stamp.time_s);
  to.text(stamp.frame);
  to.text(child);
  putPose(to, pose);
  return to.bytes();
}

std::string pose(const Stamp& stamp, const Pose2& pose) {
  FieldWriter to = stamped(stamp);
  putPose(to, pose);
  return to.bytes();
}

std::string poseWithCovariance(const Stamp& stamp, const FrameReport& report) {
  FieldWriter to = stamped(stamp);
  putPose(to, report.pose);
  putCovariance(to, &report);
  return to.bytes();
}

std::string odometry(const Stamp& stamp, std::string_view child, const Pose2& pose) {
  FieldWriter to = stamped(stamp);
  to.text(child);
  putPose(to, pose);
  putCovariance(to, nullptr);
  put(to, {0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  putCovariance(to, nullptr);
  return to.bytes();
}

std::string particles(const Stamp& stamp, const std::vector<ParticleView>& particles) {
  std::vector<float> values;
  for (const ParticleView& particle : particles) {
    for (const double value : {particle.pose.x, particle.pose.y, 0.0, particle.weight}) {
      values.push_back(static_cast<float>(value));
    }
  }
  return cloud(stamp, values, 4);
}

std::string outlines(const Stamp& stamp, const Map& map) {
  std::vector<float> values;
  for (const Building& building : map.buildings) {
    const Polygon outline = building.footprint();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2& from = outline[i];
      const Vec2 along = outline[(i + 1) % outline.size()] - from;
      const int steps = std::clamp(static_cast<int>(along.norm() / kOutlineStep_m), 1, 5000);
      for (int step = 0; step < steps; ++step) {
        const Vec2 at = from + along * (static_cast<double>(step) / steps);
        for (const double value : {at.x(), at.y(), 0.0})
          values.push_back(static_cast<float>(value));
      }
    }
  }
  return cloud(stamp, values, 3);
}

std::string markers(const Stamp& stamp, const Map& map) {
  constexpr int kLine = 4;
  constexpr int kText = 9;
  FieldWriter to = FieldWriter::cdr();
  to.count(2 * map.buildings.size());
  int number = 0;
  for (const Building& building : map.buildings) {
    Polygon outline = building.footprint();
    outline.push_back(outline.front());
    const float doubt = static_cast<float>(building.doubt.value_or(0.0));
    const Colour colour{0.1F + 0.8F * doubt, 0.35F, 0.9F - 0.7F * doubt, 1.0F};
    putMarker(to, stamp, number++, kLine, {}, 0.3, colour, outline, "");
    const Rectangle box = building.box();
    putMarker(to, stamp, number++, kText, {box.centre.x(), box.centre.y(), 0.0}, 1.5, colour, {},
              building.name.empty() ? building.id : building.name);
  }
  return to.bytes();
}

std::string grid(const Stamp& stamp, const LocalMap& map) {
  const cv::Mat1f& cells = map.cells();
  FieldWriter to = stamped(stamp);
  to.stamp(stamp.time_s);
  to.put(static_cast<float>(map.cell()));
  to.put(static_cast<std::uint32_t>(cells.cols));
  to.put(static_cast<std::uint32_t>(cells.rows));
  putPose(to, {-map.range(), -map.range(), 0.0});
  std::string data;
  data.reserve(cells.total());
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.cols; ++column) {
      data += static_cast<char>(std::lround(100.0F * std::clamp(cells(row, column), 0.0F, 1.0F)));
    }
  }
  putBytes(to, data);
  return to.bytes();
}

std::string jpeg(const Stamp& stamp, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", image, bytes, {cv::IMWRITE_JPEG_QUALITY, 80});
  FieldWriter to = stamped(stamp);
  to.text("jpeg");
  putBytes(to, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return to.bytes();
}

std::string cameraInfo(const Stamp& stamp, const StereoCamera& camera, cv::Size size) {
  FieldWriter to = stamped(stamp);
  to.put(static_cast<std::uint32_t>(size.height));
  to.put(static_cast<std::uint32_t>(size.width));
  to.text("plumb_bob");
  to.count(5);
  put(to, {0.0, 0.0, 0.0, 0.0, 0.0});
  put(to, {camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0});
  put(to, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  put(to, {camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0});
  for (int i = 0; i < 6; ++i) to.put(std::uint32_t{0});
  to.put(std::uint8_t{0});
  return to.bytes();
}

std::string log(double time_s, int level, std::string_view text) {
  FieldWriter to = FieldWriter::cdr();
  to.stamp(time_s);
  to.put(static_cast<std::uint8_t>(level));
  to.text("handmap");
  to.text(text);
  to.text("");
  to.text("");
  to.put(std::uint32_t{0});
  return to.bytes();
}

std::string numbers(const Stamp& stamp, const FrameReport& report) {
  FieldWriter to = stamped(stamp);
  put(to, {report.pose_sigma[0], report.pose_sigma[1], report.pose_sigma[2],
           report.effective_sample_size, report.within[0], report.within[1], report.within[2]});
  to.put(static_cast<std::int32_t>(report.visible_buildings));
  to.put(report.ms.total);
  return to.bytes();
}

}  // namespace handmap::ros
