// The wall likelihood read cell by cell: what LineSums is checked against and measured by.
#pragma once

#include "core/fastslam/wall_likelihood.h"
#include "core/perception/local_map.h"

namespace handmap::test {

/// The part of a–b within `range` of the origin, as shares of the way; empty where first >= second.
inline std::pair<double, double> clippedToCircle(const Vec2& a, const Vec2& b, double range) {
  const Vec2 d = b - a;
  const double squared = d.squaredNorm();
  const double middle = -a.dot(d) / squared;
  const double closest = a.squaredNorm() - middle * middle * squared;
  if (closest >= range * range) return {0.0, 0.0};
  const double half = std::sqrt((range * range - closest) / squared);
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

/// Reads every cell of every visible wall in one scalar loop.
class DirectLikelihood {
 public:
  DirectLikelihood(const BuildingModel& model, const Pose2& robot, const LocalMap& local_map)
      : model_(model),
        local_map_(local_map),
        robot_(robot),
        along_(unitVector(model.heading() - robot.heading)),
        across_(perpendicular(along_)) {}

  WallCells operator()(const BuildingState& state) const {
    const Vec2 centre = robot_.toOwn({state.x, state.y});
    const auto corner = [&](float x, float y) -> Vec2 {
      return centre + along_ * (static_cast<double>(x) * state.width) +
             across_ * static_cast<double>(y);
    };
    WallCells cells;
    for (const ModelWall& wall : model_.walls()) {
      const Vec2 from = corner(wall.from_x, wall.from_y);
      const Vec2 to = corner(wall.to_x, wall.to_y);
      // Outlines run counter-clockwise: the robot, at the origin, is outside a wall on its right.
      if (cross(from, to) < 0.0) addWall(from, to, cells);
    }
    return cells;
  }

 private:
  void addWall(const Vec2& a, const Vec2& b, WallCells& cells) const {
    // One cell inside the edge of the grid, so that rounding never leads out of it.
    const auto [first, last] = clippedToCircle(a, b, local_map_.range() - local_map_.cell());
    if (first >= last) return;
    const double cell = local_map_.cell();
    const double length = (last - first) * (b - a).norm();
    const int count = static_cast<int>(std::lround(length / cell));
    const Vec2 step = (b - a).normalized() * cell;
    const Vec2 from = a + (b - a) * first + step / 2.0;

    // Fixed point, 16 bits of fraction: the loop is all integer but for the sum.
    constexpr double kOne = 65536.0;
    const auto fixed = [](double value) { return static_cast<std::int32_t>(std::lround(value)); };
    const double origin = local_map_.range();
    std::int32_t u = fixed((from.x() + origin) / cell * kOne);
    std::int32_t v = fixed((from.y() + origin) / cell * kOne);
    const std::int32_t du = fixed(step.x() / cell * kOne);
    const std::int32_t dv = fixed(step.y() / cell * kOne);
    const cv::Mat1f& grid = local_map_.cells();
    const float* values = grid.ptr<float>();
    const int stride = grid.cols;
    float sum = 0.0F;
    int non_zero = 0;
    for (int i = 0; i < count; ++i, u += du, v += dv) {
      const float value = values[(v >> 16) * stride + (u >> 16)];
      sum += value;
      non_zero += value > 0.0F;
    }
    cells.sum += sum;
    cells.non_zero += static_cast<float>(non_zero);
    cells.all += count;
  }

  const BuildingModel& model_;
  const LocalMap& local_map_;
  Pose2 robot_;
  Vec2 along_;  ///< the building's axes in the robot frame
  Vec2 across_;
};

}  // namespace handmap::test
