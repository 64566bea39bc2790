#include "core/estimation/map_correction.h"

#include <algorithm>

#include <fmt/format.h>

namespace handmap {

void MapCorrection::correct(std::size_t b, std::span<const FoundBox> found,
                            const HasReached& has_reached) {
  constexpr double kSlightDoubt = 0.1;
  const Labels::Label label = labels_.of(b, found);
  const Building& drawn = drawing_.buildings[b];
  if (drawn.fixed) return;
  const RefinedBuilding refined =
      refinedBuilding(drawn, drawing_.uncertaintyOf(drawn), labels_.motion(), label.found);
  Building building = drawn.fitted(refined.box());
  building.estimate = refined.estimate;
  building.unknown.erase("doubtful");  // of an earlier run
  // Of what the robot has not come to yet nothing can be said.
  if (label.doubt > kSlightDoubt && (label.found || has_reached(refined.box()))) {
    building.unknown["doubtful"] = fmt::format("{:.2f}", label.doubt);
  }
  corrected_.set(b, std::move(building));
}

std::function<Map()> MapCorrection::mapLater() const {
  return [rest = rest_, buildings = buildings_] {
    Map map = *rest;
    map.buildings = buildings.all();
    return map;
  };
}

void MapCorrection::correctAll(std::span<const FoundBox> found, const HasReached& has_reached) {
  for (std::size_t b = 0; b < drawing_.buildings.size(); ++b) correct(b, found, has_reached);
  buildings_ = corrected_.share();
}

void MapCorrection::correctSome(std::span<const FoundBox> found, const HasReached& has_reached) {
  constexpr std::size_t kOthers = 100;
  for (const std::size_t b : labels_.nearby()) correct(b, found, has_reached);
  for (std::size_t i = 0; i < std::min(kOthers, drawing_.buildings.size()); ++i) {
    last_ = (last_ + 1) % drawing_.buildings.size();
    if (!labels_.isNearby(last_)) correct(last_, found, has_reached);
  }
  buildings_ = corrected_.share();
}

}  // namespace handmap
