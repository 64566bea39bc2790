#include "drivers/rosbridge/ros_publications.h"

#include <QCborArray>
#include <algorithm>
#include <cmath>
#include <vector>

namespace handmap {

namespace {

constexpr double kMargin_m = 5.0;
constexpr double kMostCells = 1e6;
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

/// Cells along a row whose centre is inside: between the 1st and 2nd, 3rd and 4th … crossing.
void fillRow(const Polygon& polygon, double y, const Vec2& origin, double cell_m,
             std::vector<bool>& cells, std::size_t row_begin, std::size_t columns) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto column = [&](double x) {
      const double cell = std::ceil((x - origin.x()) / cell_m - 0.5);
      return static_cast<std::size_t>(std::clamp(cell, 0.0, static_cast<double>(columns)));
    };
    for (std::size_t c = column(crossings[i]); c < column(crossings[i + 1]); ++c) {
      cells[row_begin + c] = true;
    }
  }
}

}  // namespace

RosTime rosTimeOf(double since_1970_s) {
  const double seconds = std::floor(since_1970_s);
  return {static_cast<std::int64_t>(seconds),
          static_cast<std::int64_t>((since_1970_s - seconds) * 1e9)};
}

QCborMap poseMessage(const RosHeader& header, const Pose2& pose,
                     const std::array<double, 3>& sigma) {
  std::array<double, 36> covariance{};
  covariance[0] = sigma[0] * sigma[0];
  covariance[7] = sigma[1] * sigma[1];
  covariance[35] = sigma[2] * sigma[2];
  QCborArray numbers;
  for (const double value : covariance) numbers.append(value);
  return map({{"header", headerOf(header)},
              {"pose", map({{"pose", poseOf(pose)}, {"covariance", numbers}})}});
}

QCborMap gridMessage(const RosHeader& header, const Map& drawing, double cell_m) {
  std::vector<Polygon> footprints;
  Vec2 low = drawing.start ? drawing.start->position() : Vec2::Zero();
  Vec2 high = low;
  for (const Building& building : drawing.buildings) {
    footprints.push_back(building.footprint());
    const Bounds bounds = boundsOf(footprints.back());
    low = low.cwiseMin(bounds.low);
    high = high.cwiseMax(bounds.high);
  }
  const Vec2 size = high - low + Vec2::Constant(2.0 * kMargin_m);
  const Vec2 origin = low - Vec2::Constant(kMargin_m);
  const double cell = std::max(cell_m, std::sqrt(size.prod() / kMostCells));
  const auto columns = static_cast<std::size_t>(std::ceil(size.x() / cell));
  const auto rows = static_cast<std::size_t>(std::ceil(size.y() / cell));
  std::vector<bool> cells(columns * rows);
  for (const Polygon& polygon : footprints) {
    const Bounds bounds = boundsOf(polygon);
    const double first = std::floor((bounds.low.y() - origin.y()) / cell);
    for (auto r = static_cast<std::size_t>(std::max(first, 0.0)); r < rows; ++r) {
      const double y = origin.y() + (static_cast<double>(r) + 0.5) * cell;
      if (y > bounds.high.y()) break;
      fillRow(polygon, y, origin, cell, cells, r * columns, columns);
    }
  }
  QCborArray data;
  for (const bool inside : cells) data.append(inside ? 100 : 0);
  const QCborMap info = map({{"map_load_time", stampOf(header.stamp, header.version)},
                             {"resolution", cell},
                             {"width", static_cast<qint64>(columns)},
                             {"height", static_cast<qint64>(rows)},
                             {"origin", poseOf({origin.x(), origin.y(), 0.0})}});
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
