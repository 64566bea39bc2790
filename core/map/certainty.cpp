#include "core/map/certainty.h"

#include <algorithm>
#include <cmath>

namespace handmap {

Sides sidesOf(const Building& building) {
  if (!building.estimate) return {};
  if (building.sides) return *building.sides;
  const Estimate& estimate = *building.estimate;
  const Vec2 along = unitVector(building.box().heading);
  const Vec2 sigma(estimate.sigma_x, estimate.sigma_y);
  const bool seen = estimate.observations > 0;
  const SideEstimate ahead{std::hypot(sigma.cwiseProduct(along).norm(), 0.5 * estimate.sigma_width),
                           seen};
  // Of two opposite sides that are off each for itself.
  const SideEstimate aside{std::numbers::sqrt2 * sigma.cwiseProduct(perpendicular(along)).norm(),
                           seen};
  return {ahead, aside, ahead, aside};
}

void setSides(Building& building, const Sides& sides) {
  building.sides = sides;
  for (SideEstimate& side : *building.sides) side.sigma = std::round(side.sigma * 1e3) / 1e3;
}

std::vector<SideEstimate> wallsOf(const Building& building) {
  const Polygon footprint = building.footprint();
  const double heading = building.box().heading;
  const Sides sides = sidesOf(building);
  std::vector<SideEstimate> walls;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Vec2 along = footprint[(i + 1) % footprint.size()] - footprint[i];
    walls.push_back(sides[sideFacing(heading, -perpendicular(along))]);
    if (building.seen_walls.size() == footprint.size()) walls.back().seen = building.seen_walls[i];
  }
  return walls;
}

std::size_t sideFacing(double heading_rad, const Vec2& outwards) {
  const double turn = std::atan2(outwards.y(), outwards.x()) - heading_rad;
  return static_cast<std::size_t>((std::lround(normalizedAngle(turn) / (kPi / 2.0)) + 4) % 4);
}

bool hasSeenWall(const Building& building) {
  return isRecognised(building) && std::ranges::any_of(sidesOf(building), &SideEstimate::seen);
}

void setDoubt(Building& building, double doubt) { building.doubt = std::round(doubt * 1e2) / 1e2; }

void copyCertainty(const Building& from, Building& to) {
  to.sides = from.sides;
  to.seen_walls = from.seen_walls;
  to.doubt = from.doubt;
}

void forgetCertainty(Building& building) {
  building.sides.reset();
  building.seen_walls.clear();
  building.doubt.reset();
}

}  // namespace handmap
