// The residuals of scan matching and of the graph of poses, each with its slope. Whitened: of unit
// variance where the model holds. Poses are (x, y, heading), changed by addition.
#pragma once

#include <optional>

#include "core/trajectory/scan_features.h"

namespace handmap {

/// A motion between two poses, as measured.
struct MotionFactor {
  Pose2 motion;                      ///< the second pose in the frame of the first
  Eigen::Matrix3d root_information;  ///< of (along, aside, heading), in the frame of the first

  struct Value {
    Eigen::Vector3d residual;
    Eigen::Matrix3d from_slope;  ///< by the first pose
    Eigen::Matrix3d to_slope;    ///< by the second
  };
  Value at(const Pose2& from, const Pose2& to) const;
};

/// The same motion, so much less sure: variance of (along, aside, heading), in the frame of the
/// first.
MotionFactor loosened(const MotionFactor& motion, const Eigen::Matrix3d& variance);

/// A return on the line of a point of the map that has a normal: one residual.
struct LineFactor {
  Vec2 point;     ///< robot frame
  ScanPoint map;  ///< outer frame
  double sigma_m;

  struct Value {
    double residual;
    Eigen::RowVector3d slope;
  };
  Value at(const Pose2& pose) const;
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
  Value at(const Pose2& pose) const;
};

/// The upper root of what is to be one; nullopt where it is no information.
std::optional<Eigen::Matrix3d> rootOf(const Eigen::Matrix3d& information);

/// Cauchy's kernel on a squared residual: cost k log(1 + s / k), and what s weighs in the normal
/// equations.
double cauchyCost(double square, double k);
inline double cauchyWeight(double square, double k) { return 1.0 / (1.0 + square / k); }

/// Pose after a step of (x, y, heading).
Pose2 stepped(const Pose2& pose, const Eigen::Vector3d& step);

}  // namespace handmap
