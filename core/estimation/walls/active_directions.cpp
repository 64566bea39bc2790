#include "core/estimation/walls/active_directions.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

void ActiveDirections::update(std::span<const double> drawn, std::span<const ActiveFrame> held,
                              WallEvidence& evidence) {
  for (Direction& direction : directions_) ++direction.unwanted;
  for (const double heading : drawn) {
    const auto near = std::ranges::find_if(directions_, [&](const Direction& d) {
      return std::abs(std::remainder(heading - d.heading, kPi / 2.0)) < kDirectionsApart / 2.0;
    });
    if (near != directions_.end()) {
      near->unwanted = 0;
    } else if (directions_.size() < kMostDirections) {
      directions_.push_back({heading});
      evidence.include(heading, held);
    }
  }
  std::erase_if(directions_, [&](const Direction& direction) {
    if (direction.unwanted <= kPatience) return false;
    evidence.exclude(direction.heading);
    return true;
  });
}

std::vector<double> ActiveDirections::drawn() const {
  std::vector<double> headings;
  for (const Direction& direction : directions_) {
    if (direction.unwanted == 0) headings.push_back(direction.heading);
  }
  return headings;
}

}  // namespace handmap
