#include "core/estimation/walls/active_directions.h"

#include <algorithm>

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

void ActiveDirections::update(std::span<const double> drawn, std::span<const ActiveFrame> held,
                              const SensorModel& sensor, WallEvidence& evidence) {
  const ActiveFrame& last = held.back();
  votes_.add(*last.frame, last.held_at, sensor);
  for (Direction& direction : directions_) {
    ++direction.unwanted;
    direction.is_drawn = false;
  }
  const auto want = [&](double heading, double apart, bool is_drawn) {
    const auto near = std::find_if(directions_.begin(), directions_.end(), [&](const Direction& d) {
      return std::abs(directionError(heading, d.heading)) < apart;
    });
    if (near != directions_.end()) {
      near->unwanted = 0;
      near->is_drawn |= is_drawn;
    } else if (directions_.size() < kMostDirections) {
      directions_.push_back({heading, is_drawn});
      evidence.include(heading, held);
    }
  };
  for (const double heading : drawn) want(heading, kDirectionsApart / 2.0, true);
  for (const double heading : votes_.peaks()) want(heading, kDirectionsApart / 1.5, false);
  std::erase_if(directions_, [&](const Direction& direction) {
    if (direction.unwanted <= kPatience) return false;
    evidence.exclude(direction.heading);
    return true;
  });
}

std::vector<double> ActiveDirections::drawn() const {
  std::vector<double> headings;
  for (const Direction& direction : directions_) {
    if (direction.is_drawn) headings.push_back(direction.heading);
  }
  return headings;
}

}  // namespace handmap
