#include "core/fastslam/building_model.h"

namespace handmap {

namespace {

/// Walls off by less than this, as the corners of a file are rounded, run straight.
constexpr double kStraight = 1e-6;

ModelWall wallBetween(const Vec2& from, const Vec2& to) {
  const Vec2 offset = (to - from).cwiseAbs();
  const auto runs = offset.y() < kStraight   ? ModelWall::Runs::Along
                    : offset.x() < kStraight ? ModelWall::Runs::Across
                                             : ModelWall::Runs::Slanted;
  const Eigen::Vector2f a = from.cast<float>();
  const Eigen::Vector2f b = to.cast<float>();
  return {runs, a.x(), a.y(), b.x(), b.y()};
}

}  // namespace

BuildingModel::BuildingModel(const Building& building) {
  const Rectangle box = building.box();
  const Pose2 frame{box.centre.x(), box.centre.y(), box.heading};
  drawn_ = {box.centre.x(), box.centre.y(), box.width};
  heading_ = normalizedAngle(box.heading);
  ahead_ = unitVector(heading_);
  depth_ = box.depth;
  for (const Vec2& corner : building.footprint()) {
    const Vec2 own = frame.toOwn(corner);
    outline_.emplace_back(own.x() / box.width, own.y());
  }
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    walls_.push_back(wallBetween(outline_[i], outline_[(i + 1) % outline_.size()]));
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
