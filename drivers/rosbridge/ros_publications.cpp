#include "drivers/rosbridge/ros_publications.h"

#include <QCborArray>
#include <algorithm>
#include <cmath>
#include <vector>

namespace handmap {

namespace {

constexpr double kLine_m = 0.3;
constexpr int kLineStrip = 4;
constexpr int kDeleteAll = 3;

QCborMap map(std::initializer_list<std::pair<const char*, QCborValue>> members) {
  QCborMap result;
  for (const auto& [key, value] : members) result.insert(QLatin1String(key), value);
  return result;
}

QCborMap stampOf(const RosTime& time, RosVersion version) {
  const bool ros1 = version == RosVersion::Ros1;
  return map({{ros1 ? "secs" : "sec", qint64{time.seconds}},
              {ros1 ? "nsecs" : "nanosec", qint64{time.nanoseconds}}});
}

QCborMap headerOf(const RosHeader& header) {
  return map({{"stamp", stampOf(header.stamp, header.version)}, {"frame_id", header.frame}});
}

QCborMap pointOf(const Vec2& point) {
  return map({{"x", point.x()}, {"y", point.y()}, {"z", 0.0}});
}

QCborMap poseOf(const Pose2& pose) {
  const double half = 0.5 * pose.heading;
  return map({{"position", pointOf(pose.position())},
              {"orientation",
               map({{"x", 0.0}, {"y", 0.0}, {"z", std::sin(half)}, {"w", std::cos(half)}})}});
}

}  // namespace

RosTime rosTimeOf(double since_1970_s) {
  const double seconds = std::floor(since_1970_s);
  return {static_cast<std::int64_t>(seconds),
          static_cast<std::int64_t>((since_1970_s - seconds) * 1e9)};
}

QCborMap poseMessage(const RosHeader& header, const Pose2& pose,
                     const Eigen::Matrix3d& covariance) {
  constexpr int kPlanar[] = {0, 1, 5};  // of x, y, z and the turns about them
  double numbers[6][6] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) numbers[kPlanar[i]][kPlanar[j]] = covariance(i, j);
  }
  QCborArray row_by_row;
  for (const auto& row : numbers) {
    for (const double number : row) row_by_row.append(number);
  }
  return map({{"header", headerOf(header)},
              {"pose", map({{"pose", poseOf(pose)}, {"covariance", row_by_row}})}});
}

QCborMap transformsMessage(const std::vector<RosTransform>& transforms, RosVersion version) {
  QCborArray all;
  for (const RosTransform& transform : transforms) {
    const QCborMap pose = poseOf(transform.pose);
    all.append(map({{"header", headerOf({transform.stamp, transform.parent, version})},
                    {"child_frame_id", transform.child},
                    {"transform", map({{"translation", pose[QLatin1String("position")]},
                                       {"rotation", pose[QLatin1String("orientation")]}})}}));
  }
  return map({{"transforms", all}});
}

QCborMap diagnosticMessage(const RosHeader& header, const RosDiagnostic& diagnostic) {
  QCborArray values;
  for (const auto& [key, value] : diagnostic.values) {
    values.append(map({{"key", key}, {"value", value}}));
  }
  const QCborMap status = map({{"level", static_cast<int>(diagnostic.level)},
                               {"name", diagnostic.name},
                               {"message", diagnostic.message},
                               {"hardware_id", QString()},
                               {"values", values}});
  return map({{"header", headerOf(header)}, {"status", QCborArray{status}}});
}

QCborMap gridMessage(const RosHeader& header, const OccupancyGrid& grid) {
  QCborArray data;
  for (const std::uint8_t inside : grid.cells) data.append(inside != 0 ? 100 : 0);
  const QCborMap info = map({{"map_load_time", stampOf(header.stamp, header.version)},
                             {"resolution", grid.cell_m},
                             {"width", static_cast<qint64>(grid.columns)},
                             {"height", static_cast<qint64>(grid.rows)},
                             {"origin", poseOf({grid.origin.x(), grid.origin.y(), 0.0})}});
  return map({{"header", headerOf(header)}, {"info", info}, {"data", data}});
}

QCborMap markersMessage(const RosHeader& header, const Map& drawing) {
  const bool ros1 = header.version == RosVersion::Ros1;
  const auto marker = [&](int id, int action, const QCborArray& points) {
    return map({{"header", headerOf(header)},
                {"ns", QStringLiteral("handmap")},
                {"id", id},
                {"type", kLineStrip},
                {"action", action},
                {"pose", poseOf({})},
                {"scale", map({{"x", kLine_m}, {"y", 0.0}, {"z", 0.0}})},
                {"color", map({{"r", 0.0}, {"g", 0.35}, {"b", 0.85}, {"a", 1.0}})},
                {"lifetime", map({{ros1 ? "secs" : "sec", 0}, {ros1 ? "nsecs" : "nanosec", 0}})},
                {"frame_locked", false},
                {"points", points}});
  };
  QCborArray markers;
  markers.append(marker(0, kDeleteAll, {}));
  int id = 0;
  for (const Building& building : drawing.buildings) {
    const Polygon footprint = building.footprint();
    QCborArray points;
    for (const Vec2& corner : footprint) points.append(pointOf(corner));
    points.append(pointOf(footprint.front()));
    markers.append(marker(++id, 0, points));
  }
  return map({{"markers", markers}});
}

}  // namespace handmap
