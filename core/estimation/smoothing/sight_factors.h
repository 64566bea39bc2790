// What a frame says of a building: how far each return is from the wall that it would be of, and at
// which bearings the building ends.
#pragma once

#include <array>
#include <optional>

#include "core/estimation/buildings/box_view.h"
#include "core/estimation/buildings/found_box.h"
#include "core/estimation/buildings/silhouette.h"
#include "core/estimation/smoothing/constants.h"
#include "core/estimation/walls/sensor_model.h"
#include "core/pose_graph/factor.h"

namespace handmap {

/// Of a pose, a box and the bias of the ranges, in this order: what a frame says of a building.
struct SightEquations {
  /// Where each begins, and how many there are.
  enum : int { kBox = smoothing::kPoseSize, kBias = kBox + smoothing::kBoxSize, kSize = kBias + 1 };

  Eigen::Matrix<double, kSize, kSize> matrix = Eigen::Matrix<double, kSize, kSize>::Zero();
  Eigen::Matrix<double, kSize, 1> right = Eigen::Matrix<double, kSize, 1>::Zero();

  void add(const ScalarFactor<kSize>& factor) {
    matrix.noalias() += factor.weight * factor.slope * factor.slope.transpose();
    right.noalias() -= factor.weight * factor.residual * factor.slope;
  }
  void add(const SightEquations& other, double share) {
    matrix += share * other.matrix;
    right += share * other.right;
  }
};

/// How ranges and walls are off beside the noise of the sensor.
struct SightErrors {
  double slack_m = 0.0;  ///< across a wall, one σ: what poses and boxes may be off
  double systematic_m =
      0.0;                  ///< across a wall, one σ: what all returns of a frame are off together
  double bias_per_m = 0.0;  ///< see RangeNoise
};

/// Distance of a return across the wall that its ray meets. States: pose, box, bias.
class ReturnFactors {
 public:
  /// Keeps references.
  ReturnFactors(const Pose2& pose, const Box& box, const SensorModel& sensor,
                const SightErrors& errors);
  /// nullopt where it is no return from the wall at `entry`.
  std::optional<ScalarFactor<SightEquations::kSize>> operator()(const FrameRay& ray,
                                                                const Entry& entry) const;

 private:
  const Pose2& pose_;
  const Box& box_;
  const SensorModel& sensor_;
  const SightErrors& errors_;
  double cos_;
  double sin_;
  Vec2 along_;  ///< of the box, its heading
  std::array<Vec2, 4> normals_;
};

/// Bearing of the corner from the pose, less that at which the returns stop. The same states.
ScalarFactor<SightEquations::kSize> endFactor(const Pose2& pose, const Box& box, const SeenEnd& end,
                                              const SightErrors& errors);

/// All of them; nullopt where the frame saw no wall of the box.
std::optional<SightEquations> sightEquations(const Frame& frame, const Box& box,
                                             const SensorModel& sensor, const SightErrors& errors);

}  // namespace handmap
