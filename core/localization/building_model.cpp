#include "core/localization/building_model.h"

namespace handmap {

BuildingModel::BuildingModel(const Building& building) {
  const Rectangle box = building.box();
  const Pose2 frame{box.centre.x(), box.centre.y(), box.heading};
  drawn_ = {box.centre.x(), box.centre.y(), box.width};
  heading_ = box.heading;
  depth_ = box.depth;
  for (const Vec2& corner : building.footprint()) {
    const Vec2 own = frame.toOwn(corner);
    outline_.emplace_back(own.x() / box.width, own.y());
  }
}

Polygon BuildingModel::footprint(const BuildingState& state) const {
  const Pose2 frame{state.x, state.y, heading_};
  Polygon corners;
  corners.reserve(outline_.size());
  for (const Vec2& corner : outline_) {
    corners.push_back(frame.toOuter({corner.x() * state.width, corner.y()}));
  }
  return corners;
}

Rectangle BuildingModel::box(const BuildingState& state) const {
  return {{state.x, state.y}, state.width, depth_, heading_};
}

}  // namespace handmap
