#include "core/session/seen_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handmap {

namespace {

constexpr int kLeastRays = 2;  // one makes no piece

struct Return {
  Vec2 end;
  Vec2 direction;
};

std::vector<Return> returnsOf(const Pose2& robot, const Scan& scan) {
  std::vector<Return> returns;
  for (const Ray& ray : scan.rays) {
    if (!ray.returned || static_cast<double>(ray.wall) < kLeastWall) continue;
    const Vec2 direction = unitVector(robot.heading + static_cast<double>(ray.bearing));
    returns.push_back({robot.position() + static_cast<double>(ray.range) * direction, direction});
  }
  return returns;
}

std::optional<SeenWall> seenPart(const Vec2& a, const Vec2& b, const Bounds& bounds,
                                 const std::vector<Return>& returns, double tolerance_m) {
  const double length = (b - a).norm();
  if (length <= 0.0) return std::nullopt;
  const Bounds wall{a.cwiseMin(b), a.cwiseMax(b)};
  if (!wall.overlaps(bounds)) return std::nullopt;
  const Vec2 along = (b - a) / length;
  const Vec2 outwards = -perpendicular(along);
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  int rays = 0;
  for (const Return& seen : returns) {
    if (-seen.direction.dot(outwards) < kLeastCosine) continue;
    const Vec2 from_a = seen.end - a;
    const double at = from_a.dot(along);
    if (at < 0.0 || at > length || std::abs(from_a.dot(outwards)) > tolerance_m) continue;
    first = std::min(first, at);
    last = std::max(last, at);
    ++rays;
  }
  if (rays < kLeastRays) return std::nullopt;
  return SeenWall{0, 0, {a + first * along, a + last * along}, rays};
}

}  // namespace

std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m) {
  std::vector<SeenWall> seen;
  const std::vector<Return> returns = returnsOf(robot, scan);
  if (returns.empty()) return seen;
  Bounds bounds{returns.front().end, returns.front().end};
  for (const Return& ray : returns) {
    bounds.low = bounds.low.cwiseMin(ray.end);
    bounds.high = bounds.high.cwiseMax(ray.end);
  }
  bounds.low.array() -= tolerance_m;
  bounds.high.array() += tolerance_m;
  for (std::size_t b = 0; b < map.buildings.size(); ++b) {
    const Polygon outline = map.buildings[b].footprint();
    for (std::size_t w = 0; w < outline.size(); ++w) {
      auto part =
          seenPart(outline[w], outline[(w + 1) % outline.size()], bounds, returns, tolerance_m);
      if (!part) continue;
      part->building = b;
      part->wall = w;
      seen.push_back(*part);
    }
  }
  return seen;
}

}  // namespace handmap
