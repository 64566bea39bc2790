#include "core/fastslam/wall_likelihood.h"

#include <cmath>

namespace handmap {

WallLikelihood::WallLikelihood(const BuildingModel& model, const Pose2& robot, const Vec2& ahead,
                               const LineSums& sums)
    : model_(model),
      sums_(sums),
      steps_(LineDirection::stepsOf(model.heading() - robot.heading)),
      along_(steps_),
      across_(steps_ + LineDirection::kHalfTurn / 2),
      cells_per_m_(static_cast<float>(1.0 / sums.cell())) {
  const Vec2 turn = sums.unitAlong(along_);
  const Vec2 along = (turn.x() * ahead + turn.y() * perpendicular(ahead)) / sums.cell();
  const Vec2 centre(model.drawn().x - robot.x, model.drawn().y - robot.y);
  ahead_x_ = static_cast<float>(along.x());
  ahead_y_ = static_cast<float>(along.y());
  drawn_u_ = static_cast<float>(along.dot(centre));
  drawn_v_ = static_cast<float>(cross(along, centre));
}

WallCells WallLikelihood::operator()(float x, float y, float width) const {
  const float u = drawn_u_ + ahead_x_ * x + ahead_y_ * y;
  const float v = drawn_v_ + ahead_x_ * y - ahead_y_ * x;
  WallCells cells;
  const float w = width * cells_per_m_;
  // Counter-clockwise: the robot, at the origin, is outside a wall on its right.
  for (const ModelWall& wall : model_.walls()) {
    const float u0 = u + wall.from_x * w;
    const float v0 = v + wall.from_y * cells_per_m_;
    switch (wall.runs) {
      case ModelWall::Runs::Along:
        if (v0 * (wall.to_x - wall.from_x) <= 0.0F) break;
        sums_.add(along_, v0, u0, u + wall.to_x * w, cells);
        break;
      case ModelWall::Runs::Across:
        if (u0 * (wall.to_y - wall.from_y) >= 0.0F) break;
        sums_.add(across_, -u0, v0, v + wall.to_y * cells_per_m_, cells);
        break;
      case ModelWall::Runs::Slanted:
        addSlanted(u0, v0, u + wall.to_x * w, v + wall.to_y * cells_per_m_, cells);
        break;
    }
  }
  return cells;
}

/// Its direction changes with the width. It is turned about its middle to the nearest direction.
void WallLikelihood::addSlanted(float u0, float v0, float u1, float v1, WallCells& cells) const {
  if (u0 * v1 >= v0 * u1) return;
  const Vec2 offset(u1 - u0, v1 - v0);
  const int turn = LineDirection::stepsOf(std::atan2(offset.y(), offset.x()));
  const Vec2 along = sums_.unitAlong(LineDirection(turn));
  const Vec2 middle(0.5F * (u0 + u1), 0.5F * (v0 + v1));
  const auto lateral = static_cast<float>(cross(along, middle));
  const auto reached = static_cast<float>(along.dot(middle));
  const auto half = static_cast<float>(offset.norm() / 2.0);
  sums_.add(LineDirection(steps_ + turn), lateral, reached - half, reached + half, cells);
}

}  // namespace handmap
