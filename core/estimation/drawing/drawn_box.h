// A drawn building as a Gaussian over its four walls, given where the drawing lies.
#pragma once

#include <algorithm>
#include <array>

#include <Eigen/Core>

#include "core/estimation/buildings/found_box.h"
#include "core/estimation/drawing/drawing_motion.h"
#include "core/map/map.h"

namespace handmap {

/// Walls in the frame of a found box: coordinates of walls 0 … 3 along the outward normals, as
/// Box::reach.
class DrawnBox {
 public:
  using Walls = Eigen::Vector4d;
  using Covariance = Eigen::Matrix4d;

  /// `frame`: any box near the place; its pivot and heading are what the walls refer to.
  DrawnBox(const Rectangle& drawn, const Uncertainty& uncertainty, const DrawingMotion& motion,
           const Box& frame);

  const Walls& mean() const { return mean_; }
  const Covariance& covariance() const { return covariance_; }  ///< without that of the motion
  const Eigen::Matrix4d& slope() const { return slope_; }       ///< by the motion

 private:
  Walls mean_;
  Covariance covariance_;
  Eigen::Matrix4d slope_;
};

/// Walls seen well enough to compare, as a mask over the four, with their σ.
struct SeenWalls {
  explicit SeenWalls(const FoundBox& found);
  std::array<int, 4> index{};
  int count = 0;
  int widths = 0;  ///< axes with both walls
  bool has(Eigen::Index wall) const {
    return std::find(index.begin(), index.begin() + count, wall) != index.begin() + count;
  }
};

}  // namespace handmap
