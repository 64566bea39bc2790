#include "core/explain/seen_walls.h"

#include <algorithm>
#include <limits>

#include "core/explain/constants.h"
#include "core/map/certainty.h"

namespace handmap {

using namespace explain;

/// What one observation saw of walls, map frame.
struct Returns {
  struct Ray {
    Vec2 end;
    Vec2 direction;
    double sigma_m;
  };
  Vec2 robot = Vec2::Zero();
  std::vector<Ray> rays;

  Bounds bounds(double margin_m) const {
    Bounds bounds{robot, robot};
    for (const Ray& ray : rays) {
      bounds.low = bounds.low.cwiseMin(ray.end);
      bounds.high = bounds.high.cwiseMax(ray.end);
    }
    bounds.low.array() -= margin_m;
    bounds.high.array() += margin_m;
    return bounds;
  }
};

namespace {

Returns returnsOf(const Pose2& robot, const Scan& scan) {
  Returns returns;
  returns.robot = robot.position();
  for (const Ray& ray : scan.rays) {
    if (!ray.returned || static_cast<double>(ray.wall) < kLeastWall) continue;
    const Vec2 direction = unitVector(robot.heading + static_cast<double>(ray.bearing));
    returns.rays.push_back({robot.position() + static_cast<double>(ray.range) * direction,
                            direction, static_cast<double>(ray.sigma)});
  }
  return returns;
}

enum class Missed { No, Through, Before };

/// Of a ray that would meet the wall: whether it ended well behind or, near by, well before it.
Missed missed(const Segment& wall, const Vec2& robot, const Returns::Ray& ray) {
  const double length = wall.length();
  if (length <= 0.0) return Missed::No;
  const Vec2 along = (wall.b - wall.a) / length;
  const Vec2 outwards = -perpendicular(along);
  const double cosine = -ray.direction.dot(outwards);
  const double away = (robot - wall.a).dot(outwards);
  if (cosine < kLeastCosine || away <= 0.0) return Missed::No;
  const double at = (robot + away / cosine * ray.direction - wall.a).dot(along);
  if (at < 0.0 || at > length) return Missed::No;
  const double before = (ray.end - wall.a).dot(outwards);
  const double least = kMissed_m + kNoiseSigmas * ray.sigma_m * cosine;
  if (before < -least) return Missed::Through;
  return before > least && before < kNear_m ? Missed::Before : Missed::No;
}

std::optional<SeenWall> seenPart(const Segment& wall, const Bounds& bounds, const Returns& returns,
                                 double tolerance_m) {
  if (!Bounds{wall.a.cwiseMin(wall.b), wall.a.cwiseMax(wall.b)}.overlaps(bounds)) {
    return std::nullopt;
  }
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  SeenWall seen{0, 0, wall, 0, 0, 0};
  for (const Returns::Ray& ray : returns.rays) {
    const auto on = onWall(wall, ray.end, ray.direction, tolerance_m);
    if (!on) {
      const Missed how = missed(wall, returns.robot, ray);
      if (how == Missed::Through) ++seen.through;
      if (how == Missed::Before) ++seen.before;
      continue;
    }
    first = std::min(first, on->at_m);
    last = std::max(last, on->at_m);
    ++seen.rays;
  }
  if (seen.rays == 0) {
    return seen.through + seen.before > 0 ? std::optional(seen) : std::nullopt;
  }
  const Vec2 along = (wall.b - wall.a).normalized();
  seen.piece = {wall.a + first * along, wall.a + last * along};
  return seen;
}

/// Walls that rays ended on or went through.
template <typename Use>
void forSeen(const std::vector<PlacedOutline>& outlines, const Returns& returns, double tolerance_m,
             Use use) {
  if (returns.rays.empty()) return;
  const Bounds bounds = returns.bounds(std::max(tolerance_m, kNear_m));
  for (const PlacedOutline& placed : outlines) {
    const Polygon& outline = placed.outline;
    for (std::size_t w = 0; w < outline.size(); ++w) {
      auto part =
          seenPart({outline[w], outline[(w + 1) % outline.size()]}, bounds, returns, tolerance_m);
      if (!part) continue;
      part->building = placed.building;
      part->wall = w;
      use(*part, placed);
    }
  }
}

}  // namespace

std::vector<PlacedOutline> outlinesOf(const Map& refined) {
  std::vector<PlacedOutline> outlines;
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    const Building& building = refined.buildings[b];
    outlines.push_back({b, building.footprint(), isRecognised(building)});
  }
  return outlines;
}

std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m) {
  std::vector<SeenWall> seen;
  forSeen(outlinesOf(map), returnsOf(robot, scan), tolerance_m,
          [&](const SeenWall& wall, const PlacedOutline&) {
            if (wall.rays >= kLeastRays) seen.push_back(wall);
          });
  return seen;
}

/// A ray that ends at a corner counts twice.
WallRays::Share WallRays::count(const std::vector<PlacedOutline>& outlines, const Returns& returns,
                                Counts& counts) {
  Share share{static_cast<int>(returns.rays.size()), 0, 0, 0};
  forSeen(outlines, returns, kOnWall_m, [&](const SeenWall& seen, const PlacedOutline& placed) {
    share.on += seen.rays;
    share.through += seen.through;
    if (!placed.found) return;
    share.met += seen.rays;
    auto& of_walls = counts[seen.building];
    of_walls.resize(placed.outline.size());
    of_walls[seen.wall].on += seen.rays;
    of_walls[seen.wall].through += seen.through;
    of_walls[seen.wall].before += seen.before;
  });
  return share;
}

WallRays::Share WallRays::add(const std::vector<PlacedOutline>& buildings, const Pose2& robot,
                              const Scan& scan) {
  return count(buildings, returnsOf(robot, scan), counts_);
}

WallRays WallRays::of(const Map& refined, const PlacedRays& placed, const Pose2& onto_map) {
  WallRays all;
  std::vector<PlacedOutline> outlines = outlinesOf(refined);
  std::erase_if(outlines, [](const PlacedOutline& outline) { return !outline.found; });
  for (std::size_t f = 0; f + 1 < placed.frame_begin.size(); ++f) {
    Returns returns;
    for (std::size_t i = placed.frame_begin[f]; i < placed.frame_begin[f + 1]; ++i) {
      const PlacedRay& ray = placed.rays[i];
      if (ray.echo != Echo::Tall) continue;
      returns.robot = onto_map.toOuter(Vec2(ray.x, ray.y));
      returns.rays.push_back({onto_map.toOuter(ray.end()),
                              onto_map.toOuter(Vec2(ray.dx, ray.dy)) - onto_map.position(),
                              placed.noise.at(static_cast<double>(ray.range))});
    }
    count(outlines, returns, all.counts_);
  }
  return all;
}

bool WallRays::wasSeen(std::size_t building, std::size_t wall) const {
  const auto of_walls = counts_.find(building);
  if (of_walls == counts_.end() || wall >= of_walls->second.size()) return false;
  const Count& count = of_walls->second[wall];
  return count.on >= kLeastOfARun && count.on >= count.through &&
         kMostBefore * count.on >= count.before;
}

void WallRays::state(const Map& drawing, Map& refined) const {
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    Building& building = refined.buildings[b];
    if (drawing.buildings[b].fixed || !isRecognised(building)) continue;
    const Polygon outline = building.footprint();
    const double heading = building.box().heading;
    Sides sides = sidesOf(building);
    std::array<bool, 4> met{};
    std::vector<bool> walls;
    for (std::size_t w = 0; w < outline.size(); ++w) {
      const Vec2 along = outline[(w + 1) % outline.size()] - outline[w];
      const std::size_t side = sideFacing(heading, -perpendicular(along));
      walls.push_back(sides[side].seen && wasSeen(b, w));
      if (walls.back()) met[side] = true;
    }
    const double drawn = drawing.uncertaintyOf(drawing.buildings[b]).size;
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (!sides[k].seen || met[k]) continue;
      sides[k] = {std::max(sides[k].sigma, drawn), false};
    }
    setSides(building, sides);
    if (outline.size() != sides.size()) building.seen_walls = std::move(walls);
  }
}

}  // namespace handmap
