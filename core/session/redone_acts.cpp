#include "core/session/redone_acts.h"

#include <algorithm>

namespace handmap {

void give(std::vector<StampedPose>& poses, const StampedPose& pose) {
  std::erase_if(poses, [&](const StampedPose& other) { return other.time_s == pose.time_s; });
  const auto after = std::ranges::upper_bound(poses, pose.time_s, {}, &StampedPose::time_s);
  poses.insert(after, pose);
}

RedoneActs redone(const Map& drawing, std::span<const Act> acts) {
  RedoneActs result{drawing, {}, {}};
  std::vector<Building>& buildings = result.drawing.buildings;
  for (const Act& act : acts) {
    if (act.kind == Act::Kind::ForgetPoses) {
      result.poses.clear();
      continue;
    }
    if (act.kind == Act::Kind::RobotIsHere) {
      give(result.poses, {act.time_s, act.pose});
      continue;
    }
    const auto building = std::ranges::find(buildings, act.building, &Building::id);
    if (act.kind == Act::Kind::BuildingIsNotThere) {
      if (building != buildings.end()) buildings.erase(building);
    } else if (building == buildings.end()) {
      result.unmatched.push_back(act.building);
    } else {
      building->shape = act.shape;
      building->fixed = true;
    }
  }
  return result;
}

}  // namespace handmap
