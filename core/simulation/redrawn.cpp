#include "core/simulation/redrawn.h"

#include <limits>

#include "core/base/random.h"

namespace handmap {

namespace {

constexpr std::uint32_t kRedrawn = 14;
constexpr std::size_t kLeastCorners = 4;
constexpr int kRedrawings = 50;

Polygon without(const Polygon& polygon, std::size_t corner) {
  Polygon rest = polygon;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(corner));
  return rest;
}

/// How far the farthest corner of `truth` lies outside or inside of the outline.
double farthestFrom(const Polygon& outline, const Polygon& truth) {
  double farthest = 0.0;
  for (const Vec2& corner : truth) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Segment wall{outline[i], outline[(i + 1) % outline.size()]};
      nearest = std::min(nearest, distanceTo(wall, corner));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

Polygon simplified(const Polygon& truth, double most_m) {
  Polygon outline = truth;
  while (outline.size() > kLeastCorners) {
    std::optional<Polygon> best;
    double least = most_m;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Polygon rest = without(outline, i);
      const double moved = farthestFrom(rest, truth);
      if (moved > least || !isSimple(rest)) continue;
      least = moved;
      best = rest;
    }
    if (!best) break;
    outline = std::move(*best);
  }
  return outline;
}

Polygon shaken(const Polygon& outline, double sigma_m, RandomStream& random) {
  for (int i = 0; i < kRedrawings; ++i) {
    Polygon moved = outline;
    for (Vec2& corner : moved) {
      corner += sigma_m * Vec2(random.normals<2>().data());
    }
    if (isSimple(moved) && signedArea(moved) > 0.0) return moved;
  }
  return outline;
}

}  // namespace

Map redrawn(const Map& truth, const Redrawing& redrawing, std::uint64_t seed) {
  Map drawn = truth;
  for (std::size_t i = 0; i < drawn.buildings.size(); ++i) {
    Building& building = drawn.buildings[i];
    if (building.fixed) continue;
    const Polygon* polygon = std::get_if<Polygon>(&building.shape);
    if (polygon && redrawing.simplify_m > 0.0) {
      building.shape = simplified(*polygon, redrawing.simplify_m);
    }
    if (redrawing.corners_m > 0.0) {
      RandomStream random(seed, static_cast<std::uint32_t>(i), 0, kRedrawn);
      building.shape = shaken(building.footprint(), redrawing.corners_m, random);
    }
  }
  return drawn;
}

}  // namespace handmap
