#include "core/method/conclusion.h"

#include <algorithm>

#include "core/explain/seen_walls.h"
#include "core/map/certainty.h"
#include "core/map_match/matched_trajectory.h"
#include "core/method/constants.h"
#include "core/outlines/refinement.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace method;

namespace {

// What decides is asked for what it must be, so that what is no number decides against.

/// The ways of walls and buildings are dropped where they make what was seen less sharp.
const TrajectoryHypothesis& believed(const RunKnowledge& known, double sharpness_alone) {
  const double needed = sharpness_alone - trajectory::kClearlySharper;
  if (known.alone.followed && !known.walls) return known.alone;
  if (known.walls && known.sharpness(known.walls->poses) >= needed) return *known.walls;
  return known.sharpness(known.buildings.poses) >= needed ? known.buildings : known.alone;
}

/// As if the drawing were right: the way laid on its walls. nullopt unless that leaves what was
/// seen as sharp as it is, and most buildings where they are drawn.
std::optional<Conclusion> asDrawn(const Map& drawing, const RunKnowledge& known,
                                  double sharpness_alone, std::uint64_t seed,
                                  const std::stop_token& stop) {
  Map from_here = drawing;
  from_here.start = known.alone.poses.front();
  MatchedTrajectory laid(from_here, known.seen);
  laid.lay(known.alone.poses,
           known.alone.by == TrajectoryHypothesis::By::Scans ? kMatchedScans : kWheels, stop);
  if (stop.stop_requested()) return std::nullopt;
  TrajectoryHypothesis trajectory{known.alone.by, laid.poses()};
  if (!(known.sharpness(trajectory.poses) >= sharpness_alone - trajectory::kClearlySharper))
    return std::nullopt;
  const PlacedRays placed = placeRays(known.seen, trajectory.poses, stop);
  const double limit_m = known.seen.rangeLimit();
  if (!(supportOf(drawing, placed, limit_m, stop) >= kMostlyRight)) return std::nullopt;
  auto refined = refine(drawing, std::nullopt, placed, limit_m, seed, stop);
  if (!refined || !(refined->right >= kMostlyRight)) return std::nullopt;
  WallRays::of(refined->map, placed, {}).state(drawing, refined->map);
  return Conclusion{std::move(trajectory), std::move(refined->map), laid.covariance()};
}

/// The drawing as it was found. Where rays came to a building and none of its walls was seen it may
/// be anything, and is where the others have it.
Map provenMap(const Map& drawing, const RunKnowledge& known, const PlacedRays& placed) {
  Map stated = known.found;
  const WallRays rays = WallRays::of(stated, placed, {});
  rays.state(drawing, stated);
  Map proven = known.found;
  const Map predicted = known.predicted();
  for (std::size_t b = 0; b < proven.buildings.size(); ++b) {
    if (rays.cameTo(b) && !hasSeenWall(stated.buildings[b]))
      proven.buildings[b] = predicted.buildings[b];
  }
  return proven;
}

/// Whether rays end on what was found rather than pass through it, along the way that was laid on
/// it: else that rests on things that are no buildings. What has no structure does not tell.
bool isFounded(const Map& found, const PlacedRays& placed, double range_limit_m,
               const std::stop_token& stop) {
  if (!placed.showsStructure()) return true;
  Map labelled = found;
  std::erase_if(labelled.buildings, [](const Building& b) { return !isRecognised(b); });
  return labelled.buildings.empty() || supportOf(labelled, placed, range_limit_m, stop) >= kFounded;
}

std::ptrdiff_t seenWalls(const Building& building) {
  return std::ranges::count_if(wallsOf(building), &SideEstimate::seen);
}

}  // namespace

bool isBetterFounded(const Building& concluded, const Building& found, const Building& drawn) {
  return !(concluded.shape == drawn.shape) || !isRecognised(found) ||
         seenWalls(concluded) > seenWalls(found);
}

std::optional<Conclusion> conclude(const Map& drawing, const RunKnowledge& known,
                                   std::uint64_t seed, const std::stop_token& stop,
                                   const std::function<void(double)>& progress) {
  if (stop.stop_requested()) return std::nullopt;
  const double alone = known.sharpness(known.alone.poses);
  if (stop.stop_requested()) return std::nullopt;
  // One placing at a time: it is what needs most memory.
  if (!known.walls && placeRays(known.seen, known.alone.poses, stop).showsStructure()) {
    if (auto conclusion = asDrawn(drawing, known, alone, seed, stop)) return conclusion;
  }
  TrajectoryHypothesis trajectory = believed(known, alone);
  PlacedRays placed = placeRays(known.seen, trajectory.poses, stop);
  if (stop.stop_requested()) return std::nullopt;
  Map proven;
  std::optional<FoundMap> found;
  bool unfounded = false;
  if (trajectory.by == TrajectoryHypothesis::By::Buildings) {
    proven = provenMap(drawing, known, placed);
    if (isFounded(proven, placed, known.seen.rangeLimit(), stop)) {
      found.emplace(FoundMap{proven, known.motion});
      // By the odometry they hold it; beside matched scans they hardly do.
      if (known.alone.by == TrajectoryHypothesis::By::Scans) trajectory.turn = known.alone.turn;
    } else {
      unfounded = true;
      // Walls may hold a way though they are not those that were drawn.
      if (!(known.sharpness(trajectory.poses) >= alone + trajectory::kClearlySharper)) {
        trajectory = known.alone;
        placed = placeRays(known.seen, trajectory.poses, stop);
      }
    }
  }
  auto refined = refine(drawing, found, placed, known.seen.rangeLimit(), seed, stop, progress,
                        trajectory.turn);
  if (!refined) return std::nullopt;
  trajectory.turn = refined->way_turn;
  const Pose2 onto_map = inverse(refined->motion);
  WallRays::of(refined->map, placed, onto_map).state(drawing, refined->map);
  for (Pose2& pose : trajectory.poses) pose = onto_map * pose;
  Conclusion conclusion{std::move(trajectory), std::move(refined->map), std::nullopt,
                        refined->start_variance};
  conclusion.unfounded = unfounded;
  if (refined->refutes_start && drawing.start) {
    conclusion.start_off = between(*drawing.start, onto_map * *drawing.start);
  }
  return conclusion;
}

}  // namespace handmap
