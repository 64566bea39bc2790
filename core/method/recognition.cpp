#include "core/method/recognition.h"

#include <algorithm>

#include "core/method/constants.h"
#include "core/method/pose_trust.h"
#include "core/odometry/odometry_noise.h"

namespace handmap {

using namespace method;

/// What a metre is worth on which walls of the drawing are recognised, on which walls that should
/// be seen are seen through, and on which walls are seen where nothing is drawn.
struct Recognition::Rates {
  double met;
  double through;
  double not_drawn;
  double most_m;  ///< what was right long ago does not count for ever
  double lost_m;  ///< against it
};

namespace {

const Recognition::Rates kFromMemory{kMet, kThrough, kNotDrawn, kMost_m, kLost_m};
const Recognition::Rates kTrue{kMet / kTrueThrough, kThrough, kNotDrawn / kTrueThrough,
                               kMost_m / kTrueThrough, kLost_m / kTrueThrough};

}  // namespace

Recognition::Recognition(Drawing drawing)
    : is_true_(drawing == Drawing::True), rates_(is_true_ ? kTrue : kFromMemory) {}

void Recognition::look(const WallRays::Share& share, double driven_m,
                       const Eigen::Matrix3d& guessed) {
  if (mayBeFar(guessed - guessed_)) {
    balance_m_ = std::min(balance_m_, 0.0);
    guessed_ = guessed;
  }
  if (share.walls < kLeastWalls) return;
  const double least = std::max(static_cast<double>(kLeastMet), kLeastShare * share.walls);
  const bool through = share.through >= least && share.through > share.on;
  const bool met = share.met >= least && !(is_true_ && through);
  unrecognised_m_ = met ? 0.0 : unrecognised_m_ + driven_m;
  const double worth = met ? rates_.met : through ? rates_.through : rates_.not_drawn;
  balance_m_ = std::min(rates_.most_m, balance_m_ + worth * driven_m);
}

void Recognition::state(Eigen::Matrix3d covariance, FrameReport& report) const {
  const double sigma = kSigmaPerMetre * std::max(0.0, -balance_m_ - rates_.lost_m);
  covariance.diagonal().head<2>().array() += sigma * sigma;
  report.unrecognised_m = unrecognised_m_;
  stateTrust(covariance, report);
}

}  // namespace handmap
