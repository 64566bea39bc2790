#include "core/method/seen_place.h"

#include <algorithm>
#include <optional>

#include "core/method/constants.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/returns.h"
#include "core/trajectory/scan_match.h"
#include "core/trajectory/submap.h"

namespace handmap {

using namespace method;

namespace {

std::vector<ScanPoint> wallsOf(const std::vector<RangePoint>& points, double range_limit_m) {
  return features(usableReturns(points, range_limit_m));
}

}  // namespace

SeenPlace::SeenPlace(const Tape& tape, const SharedList<StampedPose>& way, const Pose2& at) {
  std::optional<Pose2> last;
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Pose2& pose = way[i].pose;
    if ((pose.position() - at.position()).norm() > kAround_m) continue;
    if (last && (pose.position() - last->position()).norm() < trajectory::kKeep_m) continue;
    std::shared_ptr<const Perceived> look = tape.at(i + skipped);
    while (i + skipped < tape.end() && (!look || look->observation.time_s < way[i].time_s)) {
      look = tape.at(i + ++skipped);
    }
    if (!look) return;
    last = pose;
    const auto walls =
        moved(wallsOf(look->percept.points, tape.info().range_limit_m), between(at, pose));
    seen_.insert(seen_.end(), walls.begin(), walls.end());
  }
  seen_ = thinned(seen_, trajectory::kNear_m);
}

bool SeenPlace::isRefutedBy(const std::vector<RangePoint>& points, double range_limit_m) const {
  const std::vector<ScanPoint> now = wallsOf(points, range_limit_m);
  const auto straight = [](const std::vector<ScanPoint>& all) {
    return std::count_if(all.begin(), all.end(), [](const ScanPoint& p) { return p.straight(); });
  };
  if (std::min(straight(seen_), straight(now)) < trajectory::kLeastMatched) return false;
  // It may have rolled on, or been turned on the spot, since it was stopped.
  const auto place = WallGrid(seen_).find(now, {}, {kRolled_m, kRolledTurn});
  PointMap map;
  map.add(seen_, 0);
  const auto match = matchScan(now, map, place.value_or(Pose2()), trajectory::kLoopGates_m);
  return !match || match->straight_near < kSeenAgain * match->straight;
}

}  // namespace handmap
