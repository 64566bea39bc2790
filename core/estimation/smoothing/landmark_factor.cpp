#include "core/estimation/smoothing/landmark_factor.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/smoothing/constants.h"

namespace handmap {

using namespace smoothing;

Factor<2, kPoseSize + kLandmarkSize + 1> landmarkFactor(const Pose2& pose, const Vec2& landmark,
                                                        const Sighting& sighting, double bias_per_m,
                                                        double systematic_m) {
  const Vec2 offset = landmark - pose.position();
  const double range = std::max(offset.norm(), kNearest_m);
  const Vec2 along = offset / range;
  const Vec2 sideways = perpendicular(along) / range;
  const double bearing = std::atan2(offset.y(), offset.x()) - pose.heading;
  const Eigen::Vector2d sigma(
      std::hypot(sighting.bearing_sigma, kEndsAreWorse * systematic_m / range),
      std::hypot(sighting.range_sigma, kEndsAreWorse * systematic_m));
  Factor<2, kPoseSize + kLandmarkSize + 1> factor;
  factor.residual = {normalizedAngle(bearing - sighting.bearing),
                     range + bias_per_m * range * range - sighting.range};
  factor.jacobian << -sideways.x(), -sideways.y(), -1.0, sideways.x(), sideways.y(), 0.0,  //
      -along.x(), -along.y(), 0.0, along.x(), along.y(), range * range;
  // Cauchy's weight: some sightings are of something else.
  const double robust =
      1.0 / (1.0 + factor.residual.cwiseQuotient(sigma).squaredNorm() / (kRobust * kRobust));
  factor.weight = robust * sigma.cwiseInverse().cwiseAbs2();
  return factor;
}

}  // namespace handmap
