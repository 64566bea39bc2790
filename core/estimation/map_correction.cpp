#include "core/estimation/map_correction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/estimation/constants.h"
#include "core/map/certainty.h"

namespace handmap {

using namespace estimation;

namespace {

/// Of the box() of a corrected building: one that has turned may count its sides from another one
/// than what it was corrected with.
Sides sidesOf(const RefinedBuilding& refined, const FoundBox* found, double heading_rad) {
  const Box& walls = refined.walls;
  const auto seen =
      found ? std::optional<SeenWalls>(found->nearestTo(walls.heading)) : std::nullopt;
  const std::size_t quarters = walls.quartersTo(heading_rad);
  Sides sides;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const auto wall = static_cast<Eigen::Index>((k + quarters) % sides.size());
    // Of what is held fast, rounding may leave a variance just below zero.
    sides[k] = {std::sqrt(std::max(0.0, refined.covariance(wall, wall))), seen && seen->has(wall)};
  }
  return sides;
}

}  // namespace

Building MapCorrection::stated(std::size_t b, const RefinedBuilding& refined,
                               const FoundBox* found) const {
  Building building = drawing_.buildings[b].fitted(refined.box());
  building.estimate = refined.estimate;
  forgetCertainty(building);
  setSides(building, sidesOf(refined, found, building.box().heading));
  return building;
}

void MapCorrection::correct(std::size_t b, std::span<const FoundBox> found,
                            const HasPassed& has_passed) {
  const Labels::Label label = labels_.of(b, found);
  const Building& drawn = drawing_.buildings[b];
  if (drawn.fixed) return;
  const Uncertainty uncertainty = drawing_.uncertaintyOf(drawn);
  const RefinedBuilding predicted = refinedBuilding(drawn, uncertainty, motionBeside(b), nullptr);
  const RefinedBuilding refined =
      label.found ? refinedBuilding(drawn, uncertainty, labels_.motion(), label.found) : predicted;
  Building building = stated(b, refined, label.found);
  // Of what is still ahead of the robot nothing can be said.
  if (label.doubt > kSlightDoubt && (label.found || has_passed(refined.box()))) {
    setDoubt(building, label.doubt);
  }
  predicted_.set(b, label.found ? stated(b, predicted, nullptr) : building);
  corrected_.set(b, std::move(building));
}

/// As the drawing would have it without the other buildings.
void MapCorrection::compare(std::size_t b, std::span<const FoundBox> found) {
  const FoundBox* box = labels_.of(b, found).found;
  displaced_[b].reset();
  if (!box) return;
  const Building& drawn = drawing_.buildings[b];
  const Uncertainty uncertainty = drawing_.uncertaintyOf(drawn);
  const RefinedBuilding alone = refinedBuilding(drawn, uncertainty, labels_.expectedMotion(), box);
  displaced_[b] = {drawn.box().centre, alone.box().centre,
                   std::max(uncertainty.position, kLeastDrawn_m)};
}

void MapCorrection::predict() {
  found_.clear();
  for (const std::optional<Displaced>& building : displaced_) {
    if (building) found_.push_back(*building);
  }
  share_ = predictiveShare(labels_.expectedMotion(), found_);
}

DrawingMotion MapCorrection::motionBeside(std::size_t b) const {
  const Vec2 here = drawing_.buildings[b].box().centre;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Displaced& other : found_) {
    if (other.drawn != here) nearest = std::min(nearest, (other.drawn - here).norm());
  }
  return predictedMotion(labels_.expectedMotion(), labels_.motion(), shareAt(nearest, share_));
}

std::function<Map()> MapCorrection::mapLater() const { return later(buildings_); }

std::function<Map()> MapCorrection::predictedLater() const { return later(predicted_buildings_); }

std::function<Map()> MapCorrection::later(const SharedList<Building>& buildings) const {
  return [rest = rest_, buildings] {
    Map map = *rest;
    map.buildings = buildings.all();
    return map;
  };
}

void MapCorrection::share() {
  buildings_ = corrected_.share();
  predicted_buildings_ = predicted_.share();
}

void MapCorrection::correctAll(std::span<const FoundBox> found, const HasPassed& has_passed) {
  for (std::size_t b = 0; b < drawing_.buildings.size(); ++b) compare(b, found);
  predict();
  for (std::size_t b = 0; b < drawing_.buildings.size(); ++b) correct(b, found, has_passed);
  share();
}

void MapCorrection::correctSome(std::span<const FoundBox> found, const HasPassed& has_passed) {
  for (const std::size_t b : labels_.nearby()) compare(b, found);
  predict();
  for (const std::size_t b : labels_.nearby()) correct(b, found, has_passed);
  for (std::size_t i = 0; i < std::min(kMostCorrected, drawing_.buildings.size()); ++i) {
    last_ = (last_ + 1) % drawing_.buildings.size();
    if (!labels_.isNearby(last_)) correct(last_, found, has_passed);
  }
  share();
}

}  // namespace handmap
