#include "core/map/map.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

Polygon Building::footprint() const {
  if (const auto* rectangle = std::get_if<Rectangle>(&shape)) return rectangle->corners();
  return std::get<Polygon>(shape);
}

Rectangle Building::box() const {
  if (const auto* rectangle = std::get_if<Rectangle>(&shape)) return *rectangle;
  const auto& polygon = std::get<Polygon>(shape);
  return boundingRectangle(polygon, principalHeading(polygon));
}

Building Building::fitted(const Rectangle& target) const {
  Building result = *this;
  auto* polygon = std::get_if<Polygon>(&result.shape);
  if (polygon == nullptr) {
    result.shape = target;
    return result;
  }
  const Rectangle from = box();
  const Pose2 from_frame{from.centre.x(), from.centre.y(), from.heading};
  const Pose2 to_frame{target.centre.x(), target.centre.y(), target.heading};
  const Vec2 stretch(target.width / from.width, target.depth / from.depth);
  for (Vec2& corner : *polygon) {
    corner = to_frame.toOuter(from_frame.toOwn(corner).cwiseProduct(stretch));
  }
  return result;
}

Uncertainty Map::uncertaintyOf(const Building& building) const {
  constexpr Uncertainty kFinest{0.05, 0.05};  // of a map that was surveyed
  if (building.fixed) return kFinest;
  const Uncertainty stated = building.uncertainty.value_or(uncertainty);
  return {std::max(stated.position, kFinest.position), std::max(stated.size, kFinest.size)};
}

double Map::shiftSigma() const {
  return whole.shift.value_or(kUsualShiftShare * uncertainty.position);
}

const Building* Map::find(const std::string& id) const {
  const auto found = std::find_if(buildings.begin(), buildings.end(),
                                  [&](const Building& building) { return building.id == id; });
  return found == buildings.end() ? nullptr : &*found;
}

void requireReadyToRun(const Map& drawing) {
  if (drawing.buildings.empty()) {
    throw Error(ErrorCode::BadInput, phrase("the map has no building, expected at least one"),
                phrase("draw the buildings that the robot will pass"));
  }
  if (!drawing.start) {
    throw Error(ErrorCode::BadInput, phrase("the map has no start pose, expected one"),
                phrase("set where the robot starts and where it looks"));
  }
}

}  // namespace handmap
