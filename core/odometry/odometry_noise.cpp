#include "core/odometry/odometry_noise.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/pose_covariance.h"
#include "core/odometry/constants.h"

namespace handmap {

using namespace odometry;

Eigen::Vector3d OdometryNoise::sigmaOf(const Pose2& motion) const {
  const double length = motion.position().norm();
  const double heading = std::sqrt(heading_variance_per_m * length) +
                         heading_per_rad * std::abs(motion.heading) + least_heading;
  return {along_per_m * length + least_m, aside_per_m * length + least_m, heading};
}

Eigen::Matrix3d guessedOf(const Odometry& from, const Odometry& to) {
  return turnedBy(-from.pose.heading, to.guessed - from.guessed);
}

bool mayBeFar(const Eigen::Matrix3d& guessed) {
  return guessed.topLeftCorner<2, 2>().trace() > kKeyframe_m * kKeyframe_m;
}

double Guess::off_m() const {
  const double share = knows_speed_ ? std::min(1.0, since_s_ / kAnySpeed_s) : 1.0;
  return kUnheard_m_s * since_s_ * share;
}

void Guess::goOn(double elapsed_s, Of what, const Vec2& along) {
  const double before_m = off_m();
  const double before_s = since_s_;
  since_s_ += elapsed_s;
  // Off in the same sense all the time, so that σ adds up, not its square.
  const double grown = off_m() * off_m() - before_m * before_m;
  if (what == Of::Along) {
    variance_.topLeftCorner<2, 2>() += grown * along * along.transpose();
    return;
  }
  const double turned = kUnheard_rad_s * kUnheard_rad_s;
  variance_.diagonal() +=
      Eigen::Vector3d(grown, grown, turned * (since_s_ * since_s_ - before_s * before_s));
}

}  // namespace handmap
