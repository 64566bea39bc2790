#include "core/estimation/smoothing/odometry_factor.h"

#include <cmath>

#include <Eigen/Cholesky>

namespace handmap {

using namespace smoothing;

Factor<3, 2 * kPoseSize + 1> odometryFactor(const Frame& from, const Frame& to, double scale,
                                            const OdometryNoise& noise) {
  const Pose2 counted = between(from.odometry, to.odometry);
  const Pose2 measured = scaled(counted, scale);
  const Pose2 step = between(from.pose, to.pose);
  const Eigen::Vector3d sigma = to.odometry_noise * noise.sigmaOf(measured);
  const double c = std::cos(from.pose.heading);
  const double s = std::sin(from.pose.heading);
  Factor<3, 2 * kPoseSize + 1> factor;
  factor.residual = {step.x - measured.x, step.y - measured.y,
                     normalizedAngle(step.heading - measured.heading)};
  factor.jacobian << -c, -s, step.y, c, s, 0.0, -counted.x,  //
      s, -c, -step.x, -s, c, 0.0, -counted.y,                //
      0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0;
  const Eigen::Matrix3d guessed =
      guessedOf({from.odometry, from.guessed}, {to.odometry, to.guessed});
  if (guessed.isZero()) {
    factor.weight = sigma.cwiseInverse().cwiseAbs2();
    return factor;
  }
  Eigen::Matrix3d covariance = guessed;
  covariance.diagonal() += sigma.cwiseAbs2();
  const Eigen::LLT<Eigen::Matrix3d> root(covariance);
  root.matrixL().solveInPlace(factor.residual);
  root.matrixL().solveInPlace(factor.jacobian);
  factor.weight.setOnes();
  return factor;
}

}  // namespace handmap
