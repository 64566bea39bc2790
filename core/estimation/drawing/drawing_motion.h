// How a drawing lies against the place it is of.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace handmap {

/// How the drawing as a whole is shifted, turned and scaled about the robot's start.
struct DrawingMotion {
  Vec2 origin = Vec2::Zero();
  /// a, b, x, y of p ↦ origin + (a −b; b a) (p − origin) + (x, y).
  Eigen::Vector4d mean{1.0, 0.0, 0.0, 0.0};
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();

  Vec2 operator()(const Vec2& p) const {
    const Vec2 q = p - origin;
    return p + Vec2((mean[0] - 1.0) * q.x() - mean[1] * q.y() + mean[2],
                    mean[1] * q.x() + (mean[0] - 1.0) * q.y() + mean[3]);
  }
  /// What is known of it changes by a measured slope · (a, b, x, y) = value, with a variance.
  void correct(const Eigen::RowVector4d& slope, double value, double variance);

  using Slope = Eigen::Matrix<double, 2, 4>;
  /// Of where a drawn point is, by (a, b, x, y).
  Slope slopeAt(const Vec2& p) const {
    const Vec2 q = p - origin;
    Slope slope;
    slope << q.x(), -q.y(), 1.0, 0.0, q.y(), q.x(), 0.0, 1.0;
    return slope;
  }
  /// How well it is known where a drawn point is: the greatest σ of any direction, or more.
  double sigmaAt(const Vec2& p) const {
    const Slope slope = slopeAt(p);
    return std::sqrt((slope * covariance * slope.transpose()).trace());
  }

  double scale() const { return std::hypot(mean[0], mean[1]); }
  double turn() const { return std::atan2(mean[1], mean[0]); }
};

}  // namespace handmap
