// Height of the ground around a robot, from a scan that also sees the ground.
#pragma once

#include <cstddef>
#include <vector>

#include "core/recording/observation.h"

namespace handmap {

/// Square cells around the robot, metres; every point must lie within `range` of it in x and y.
class PlaneCells {
 public:
  PlaneCells(float range, float cell)
      : range_(range), cell_(cell), side_(static_cast<int>(2.0F * range / cell) + 1) {}
  int side() const { return side_; }
  std::size_t count() const { return index(0, side_); }
  int columnOf(float x) const { return static_cast<int>((x + range_) / cell_); }
  std::size_t of(float x, float y) const { return index(columnOf(x), columnOf(y)); }
  /// Middle of a cell.
  Vec2 centreOf(std::size_t cell) const {
    const auto side = static_cast<std::size_t>(side_);
    const double middle = 0.5 * cell_ - range_;
    const std::size_t row = cell / side;
    return {cell_ * static_cast<double>(cell % side) + middle,
            cell_ * static_cast<double>(row) + middle};
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row * side_ + column);
  }

 private:
  float range_;
  float cell_;
  int side_;
};

/// The ground is at 0 under the robot and is followed outwards, cell by cell, along the low points
/// but no steeper than a street: a roof or a crown seen alone does not lift it.
class GroundHeight {
 public:
  GroundHeight(const std::vector<RangePoint>& points, float range_m);
  float at(float x, float y) const { return height_[cells_.of(x, y)]; }

 private:
  std::vector<float> lowHeights(const std::vector<RangePoint>& points) const;

  PlaneCells cells_;
  std::vector<float> height_;
};

}  // namespace handmap
