#include "core/session/seen_walls.h"

#include <algorithm>
#include <limits>

#include "core/map/certainty.h"

namespace handmap {

namespace {

constexpr int kLeastRays = 2;    // one makes no piece
constexpr int kLeastOfARun = 3;  // fewer may be strays

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

Bounds boundsOf(const std::vector<Return>& returns, double margin_m) {
  Bounds bounds{returns.front().end, returns.front().end};
  for (const Return& ray : returns) {
    bounds.low = bounds.low.cwiseMin(ray.end);
    bounds.high = bounds.high.cwiseMax(ray.end);
  }
  bounds.low.array() -= margin_m;
  bounds.high.array() += margin_m;
  return bounds;
}

std::optional<SeenWall> seenPart(const Segment& wall, const Bounds& bounds,
                                 const std::vector<Return>& returns, double tolerance_m) {
  if (!Bounds{wall.a.cwiseMin(wall.b), wall.a.cwiseMax(wall.b)}.overlaps(bounds)) {
    return std::nullopt;
  }
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  int rays = 0;
  for (const Return& seen : returns) {
    const auto on = onWall(wall, seen.end, seen.direction, tolerance_m);
    if (!on) continue;
    first = std::min(first, on->at_m);
    last = std::max(last, on->at_m);
    ++rays;
  }
  if (rays == 0) return std::nullopt;
  const Vec2 along = (wall.b - wall.a).normalized();
  return SeenWall{0, 0, {wall.a + first * along, wall.a + last * along}, rays};
}

/// Walls that have returns.
template <typename Use>
void forSeen(const std::vector<FoundOutline>& outlines, const std::vector<Return>& returns,
             double tolerance_m, Use use) {
  if (returns.empty()) return;
  const Bounds bounds = boundsOf(returns, tolerance_m);
  for (const auto& [building, outline] : outlines) {
    for (std::size_t w = 0; w < outline.size(); ++w) {
      auto part =
          seenPart({outline[w], outline[(w + 1) % outline.size()]}, bounds, returns, tolerance_m);
      if (!part) continue;
      part->building = building;
      part->wall = w;
      use(*part, outline.size());
    }
  }
}

bool wasFound(const Building& building) {
  return building.estimate && building.estimate->observations > 0;
}

/// Returns how many; one at a corner counts twice.
int count(const std::vector<FoundOutline>& outlines, const std::vector<Return>& returns,
          std::map<std::size_t, std::vector<int>>& rays) {
  int all = 0;
  forSeen(outlines, returns, kOnWall_m, [&](const SeenWall& seen, std::size_t walls) {
    auto& of_walls = rays[seen.building];
    of_walls.resize(walls);
    of_walls[seen.wall] += seen.rays;
    all += seen.rays;
  });
  return all;
}

}  // namespace

std::vector<FoundOutline> foundOutlines(const Map& refined) {
  std::vector<FoundOutline> outlines;
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    if (wasFound(refined.buildings[b])) outlines.push_back({b, refined.buildings[b].footprint()});
  }
  return outlines;
}

std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m) {
  std::vector<FoundOutline> outlines;
  for (std::size_t b = 0; b < map.buildings.size(); ++b)
    outlines.push_back({b, map.buildings[b].footprint()});
  std::vector<SeenWall> seen;
  forSeen(outlines, returnsOf(robot, scan), tolerance_m, [&](const SeenWall& wall, std::size_t) {
    if (wall.rays >= kLeastRays) seen.push_back(wall);
  });
  return seen;
}

WallRays::Share WallRays::add(const std::vector<FoundOutline>& found, const Pose2& robot,
                              const Scan& scan) {
  const std::vector<Return> returns = returnsOf(robot, scan);
  return {static_cast<int>(returns.size()), count(found, returns, rays_)};
}

WallRays WallRays::of(const Map& refined, const PlacedRays& placed, const Pose2& onto_map) {
  WallRays all;
  const std::vector<FoundOutline> outlines = foundOutlines(refined);
  std::vector<Return> returns;
  for (std::size_t f = 0; f + 1 < placed.frame_begin.size(); ++f) {
    returns.clear();
    for (std::size_t i = placed.frame_begin[f]; i < placed.frame_begin[f + 1]; ++i) {
      const PlacedRay& ray = placed.rays[i];
      if (ray.echo != Echo::Tall) continue;
      const Vec2 direction(ray.dx, ray.dy);
      returns.push_back(
          {onto_map.toOuter(ray.end()), onto_map.toOuter(direction) - onto_map.position()});
    }
    count(outlines, returns, all.rays_);
  }
  return all;
}

int WallRays::at(std::size_t building, std::size_t wall) const {
  const auto of_walls = rays_.find(building);
  return of_walls == rays_.end() || wall >= of_walls->second.size() ? 0 : of_walls->second[wall];
}

void WallRays::state(const Map& drawing, Map& refined) const {
  for (std::size_t b = 0; b < refined.buildings.size(); ++b) {
    Building& building = refined.buildings[b];
    if (drawing.buildings[b].fixed || !wasFound(building)) continue;
    const Polygon outline = building.footprint();
    const double heading = building.box().heading;
    Sides sides = sidesOf(building);
    std::array<bool, 4> met{};
    std::vector<bool> walls;
    for (std::size_t w = 0; w < outline.size(); ++w) {
      const Vec2 along = outline[(w + 1) % outline.size()] - outline[w];
      const std::size_t side = sideFacing(heading, -perpendicular(along));
      walls.push_back(sides[side].seen && at(b, w) >= kLeastOfARun);
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
