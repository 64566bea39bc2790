// Which found building is which drawn one: hypotheses over all of them together.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/estimation/box_finder.h"
#include "core/geometry/pose2.h"
#include "core/map/map.h"

namespace handmap {

struct AssignmentOptions {
  int hypotheses = 100;
  double undrawn = 0.05;    ///< found buildings that no one drew, as a share of the drawn ones
  double phantom = 0.02;    ///< drawn buildings that are not there or were not found, share
  double built_on = 0.02;   ///< share of the walls that are of something no one drew
  double disorder = 2.0;    ///< price of two buildings that change places in the drawing, nats
  double wrong_side = 3.0;  ///< and of one found on the other side of the robot's way
  double heading_sigma = toRadians(3.0);  ///< of a building against the drawing
  double scale_sigma = 0.05;              ///< of the whole drawing
  double turn_sigma = toRadians(1.0);
  bool free_scale = false;   ///< the drawing may be 0.7 to 1.4 times as large
  bool free_turn = false;    ///< and turned by ±40° about the robot's start
  double shift_share = 0.3;  ///< of the whole drawing, as a share of the uncertainty of a building
};

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

  double scale() const { return std::hypot(mean[0], mean[1]); }
  double turn() const { return std::atan2(mean[1], mean[0]); }
};

/// One way to assign all; what the assigned ones say of the whole drawing is marginalised exactly
/// (Rao-Blackwell: a discrete particle with a Gaussian of its own).
struct Hypothesis {
  static constexpr int kNone = -1;
  std::vector<int> found_of;  ///< by drawn building; kNone: left out
  DrawingMotion motion;
  double log_weight = 0.0;
  double weight = 0.0;  ///< normalized
};

/// The best hypotheses, the best first. Not empty. `way`: where the robot has been, map frame.
std::vector<Hypothesis> assign(const Map& drawing, std::span<const FoundBox> found,
                               std::span<const Pose2> way, const AssignmentOptions& options);

}  // namespace handmap
