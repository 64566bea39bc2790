#include "core/map/map_changes.h"

#include <algorithm>

#include "core/map/certainty.h"

namespace handmap {

MapChanges changesOf(const Map& drawing, const Map& refined) {
  MapChanges changes;
  const std::size_t count = std::min(drawing.buildings.size(), refined.buildings.size());
  for (std::size_t b = 0; b < count; ++b) {
    const Building& now = refined.buildings[b];
    const BuildingChange change{b, centroid(drawing.buildings[b].footprint()),
                                centroid(now.footprint()), doubtOf(now)};
    const bool seen = now.estimate && now.estimate->observations > 0;
    auto& group = !seen                             ? changes.unseen
                  : change.moved_m() < kLeastMove_m ? changes.kept
                                                    : changes.moved;
    group.push_back(change);
    if (change.doubt > 0.0) changes.doubtful.push_back(change);
  }
  std::ranges::stable_sort(changes.moved, std::greater(), &BuildingChange::moved_m);
  std::ranges::stable_sort(changes.doubtful, std::greater(), &BuildingChange::doubt);
  return changes;
}

TrueMiddles::TrueMiddles(const Map& truth) {
  for (const Building& building : truth.buildings)
    middles_.emplace(building.id, centroid(building.footprint()));
}

std::optional<double> TrueMiddles::errorOf(const Building& building) const {
  const auto middle = middles_.find(building.id);
  if (middle == middles_.end()) return std::nullopt;
  return (centroid(building.footprint()) - middle->second).norm();
}

}  // namespace handmap
