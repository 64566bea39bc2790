// The residuals of scan matching, each with its slope. Whitened: of unit variance where the model
// holds. Poses are (x, y, heading), changed by addition.
#pragma once

#include "core/geometry/to_outer.h"
#include "core/trajectory/scan_features.h"

namespace handmap {

/// A return on the line of a point of the map that has a normal: one residual.
struct LineFactor {
  Vec2 point;     ///< robot frame
  ScanPoint map;  ///< outer frame
  double sigma_m;

  struct Value {
    double residual;
    Eigen::RowVector3d slope;
  };
  Value at(const ToOuter& robot) const;
};

/// A return at a point of the map: two residuals.
struct PointFactor {
  Vec2 point;  ///< robot frame
  Vec2 map;    ///< outer frame
  double sigma_m;

  struct Value {
    Vec2 residual;
    Eigen::Matrix<double, 2, 3> slope;
  };
  Value at(const ToOuter& robot) const;
};

}  // namespace handmap
