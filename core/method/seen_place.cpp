#include "core/method/seen_place.h"

#include <algorithm>
#include <optional>

#include "core/base/median.h"
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
    looks_.push_back(
        moved(wallsOf(look->percept.points, tape.info().range_limit_m), between(at, pose)));
  }
}

bool SeenPlace::isRefutedBy(const std::vector<RangePoint>& points, double range_limit_m) const {
  const auto again = shareSeen(wallsOf(points, range_limit_m), nullptr);
  std::vector<double> usual;
  for (const auto& look : looks_) {
    if (const auto share = shareSeen(look, &look)) usual.push_back(*share);
  }
  if (!again || usual.empty()) return false;
  return *again < kSeenAgain * medianOf(usual);
}

std::optional<double> SeenPlace::shareSeen(const std::vector<ScanPoint>& now,
                                           const std::vector<ScanPoint>* left_out) const {
  std::vector<ScanPoint> seen;
  for (const auto& look : looks_) {
    if (&look != left_out) seen.insert(seen.end(), look.begin(), look.end());
  }
  seen = thinned(seen, trajectory::kNear_m);
  const auto straight = [](const std::vector<ScanPoint>& all) {
    return std::count_if(all.begin(), all.end(), [](const ScanPoint& p) { return p.straight(); });
  };
  if (std::min(straight(seen), straight(now)) < trajectory::kLeastMatched) return std::nullopt;
  // It may have rolled on, or been turned on the spot, since it was stopped.
  const auto place = WallGrid(seen).find(now, {}, {kRolled_m, kRolledTurn});
  PointMap map;
  map.add(seen, 0);
  const auto match = matchScan(now, map, place.value_or(Pose2()), trajectory::kLoopGates_m);
  return match ? static_cast<double>(match->near) / match->known : 0.0;
}

}  // namespace handmap
