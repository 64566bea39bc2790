#include "core/sketching/snapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace handmap {

namespace {

constexpr double kParallelSine = 0.05;  // below it a crossing is nowhere in particular
constexpr double kLineReach = 0.6;      // of the reach: what is far away draws less

double distanceToLine(const Vec2& at, const Vec2& along, const Vec2& point) {
  return std::abs(cross(along, point - at));
}

}  // namespace

struct Snapper::Line {
  Vec2 at;     ///< lengths along it are counted from here
  Vec2 along;  ///< unit vector
  SnapKind kind;
  double distance;  ///< of the pointer
};

Vec2 roundedTo(const Vec2& point, double step) {
  // Through the number of steps in one, so that 0.1-steps give 0.3 and not 0.30000000000000004.
  const double steps = std::round(1.0 / step);
  if (step < 1.0) return (point * steps).array().round() / steps;
  return (point / step).array().round() * step;
}

Snap Snapper::snap(const Vec2& pointer, const SnapCandidates& candidates) const {
  if (modes_.objects) {
    if (const auto found = corner(pointer, candidates)) return *found;
    const std::vector<Line> near = lines(pointer, candidates);
    if (const auto found = crossing(pointer, near)) return *found;
    if (!near.empty()) {
      const Line& line = near.front();
      const Vec2 point = onLine(line, pointer);
      return {point, line.kind, {{line.at, point}}};
    }
  }
  return {roundedTo(pointer, step()), modes_.grid ? SnapKind::Grid : SnapKind::None};
}

std::optional<Snap> Snapper::corner(const Vec2& pointer, const SnapCandidates& candidates) const {
  std::optional<Snap> best;
  double least = reach_;
  for (const Segment& wall : candidates.walls) {
    for (const Vec2& end : {wall.a, wall.b}) {
      const double distance = (end - pointer).norm();
      if (distance > least || std::ranges::count(candidates.from, end) > 0) continue;
      least = distance;
      best = Snap{end, SnapKind::Corner};
    }
  }
  return best;
}

/// Those within reach, the strongest and nearest first.
std::vector<Snapper::Line> Snapper::lines(const Vec2& pointer,
                                          const SnapCandidates& candidates) const {
  std::vector<Line> near;
  for (const Segment& wall : candidates.walls) {
    if (wall.length() <= 0.0) continue;
    const Vec2 along = (wall.b - wall.a) / wall.length();
    const double to_line = distanceToLine(wall.a, along, pointer);
    if (to_line > reach_) continue;
    if (distanceTo(wall, pointer) <= reach_)
      near.push_back({wall.a, along, SnapKind::Wall, to_line});
    else if (to_line <= kLineReach * reach_)
      near.push_back({wall.a, along, SnapKind::Line, to_line});
  }
  for (const Vec2& from : candidates.from) {
    std::vector<Vec2> directions = {Vec2::UnitX(), Vec2::UnitY()};
    if (candidates.along && candidates.along->norm() > 0.0) {
      directions.push_back(candidates.along->normalized());
      directions.push_back(perpendicular(directions.back()));
    }
    for (const Vec2& direction : directions) {
      const double distance = distanceToLine(from, direction, pointer);
      if (distance <= reach_) near.push_back({from, direction, SnapKind::RightAngle, distance});
    }
  }
  std::ranges::stable_sort(near, [](const Line& a, const Line& b) {
    return std::tuple(-static_cast<int>(a.kind), a.distance) <
           std::tuple(-static_cast<int>(b.kind), b.distance);
  });
  return near;
}

std::optional<Snap> Snapper::crossing(const Vec2& pointer, const std::vector<Line>& lines) const {
  if (lines.empty()) return std::nullopt;
  const Line& first = lines.front();
  for (const Line& second : lines) {
    const double sine = cross(first.along, second.along);
    if (std::abs(sine) < kParallelSine) continue;
    const Vec2 point = first.at + first.along * (cross(second.at - first.at, second.along) / sine);
    if ((point - pointer).norm() > 1.5 * reach_) continue;
    return Snap{point, SnapKind::Crossing, {{first.at, point}, {second.at, point}}};
  }
  return std::nullopt;
}

/// At a tidy distance from where the line is counted from.
Vec2 Snapper::onLine(const Line& line, const Vec2& pointer) const {
  const double along = (pointer - line.at).dot(line.along);
  return line.at + line.along * (std::round(along / step()) * step());
}

Snap Snapper::snapOffset(const std::vector<Vec2>& corners, const Vec2& offset,
                         const SnapCandidates& candidates) const {
  Snap best{roundedTo(offset, step())};
  double least = std::numeric_limits<double>::infinity();
  SnapCandidates others = candidates;
  others.from.clear();
  for (const Vec2& corner : corners) {
    const Vec2 there = corner + offset;
    Snap found = snap(there, others);
    if (found.kind <= SnapKind::Grid) continue;
    // What draws along one line only leaves the way along it as it was.
    const double distance = (found.point - there).norm();
    if (std::tuple(-static_cast<int>(found.kind), distance) >=
        std::tuple(-static_cast<int>(best.kind), least))
      continue;
    least = distance;
    best = Snap{found.point - corner, found.kind, std::move(found.guides)};
  }
  return best;
}

}  // namespace handmap
