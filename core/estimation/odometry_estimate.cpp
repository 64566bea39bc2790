#include "core/estimation/odometry_estimate.h"

namespace handmap {

void OdometryEstimate::add(const Frame& from, const Frame& to, double way_m) {
  constexpr double kForgetting = 0.98;
  const double counted = between(from.odometry, to.odometry).heading;
  const double error = normalizedAngle(between(from.pose, to.pose).heading - counted);
  turned_ = kForgetting * turned_ + error * error;
  way_m_ = kForgetting * way_m_ + way_m;
}

}  // namespace handmap
