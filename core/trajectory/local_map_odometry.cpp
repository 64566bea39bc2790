#include "core/trajectory/local_map_odometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "core/geometry/pose_covariance.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

std::optional<Vec2> unheldOf(const ScanMatch& match) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(
      match.information.topLeftCorner<2, 2>());
  if (axes.eigenvalues()(0) > kHeld * match.chance) return std::nullopt;
  return axes.eigenvectors().col(0);
}

/// A match strays with each metre by as much as it is unsure of: what comes next is matched with
/// what it left. The wheels hold what it does not.
Eigen::Matrix3d strayOf(const ScanMatch& match, const MotionFactor& wheels) {
  const Pose2& motion = wheels.motion;
  const double way_m =
      motion.position().norm() + odometry::kMetresARadian * std::abs(motion.heading);
  const Eigen::Matrix3d known = wheels.root_information.transpose() * wheels.root_information;
  const Eigen::Matrix3d own = turnedBy(-match.pose.heading, match.information / match.misfit);
  return (known + own * (kStraysIn_m / std::max(way_m, kStill_m))).inverse();
}

/// What is followed over many steps errs by the way; the steps add nothing.
Eigen::Vector3d followedSigma(const Pose2& motion) {
  OdometryNoise noise = kMatchedScans;
  noise.least_m = kStill_m;
  noise.least_heading = kStill;
  return noise.sigmaOf(motion);
}

double explained(const std::optional<ScanMatch>& match) {
  return match ? match->near / std::max(1.0, static_cast<double>(match->known)) : 0.0;
}

}  // namespace

LocalMapOdometry LocalMapOdometry::ofGuesses() {
  LocalMapOdometry odometry;
  odometry.noise_ = WheelNoise::ofGuesses();
  odometry.guessed_ = true;
  return odometry;
}

std::optional<ScanMatch> LocalMapOdometry::bestMatch(const std::vector<ScanPoint>& scan,
                                                     const MotionPrior& prior) const {
  const Pose2 start = prior.from * prior.motion.motion;
  auto best = matchScan(scan, map_, start, kGates_m, prior);
  if (!guessed_ || explained(best) >= kExplained) return best;
  for (const double turn : kOtherTurns) {
    MotionPrior turned = prior;  // along a wall nothing else holds it
    turned.motion.motion.heading += turn;
    auto other = matchScan(scan, map_, turned.from * turned.motion.motion, kGates_m, turned);
    if (explained(other) > explained(best)) best = std::move(other);
  }
  return best;
}

bool LocalMapOdometry::add(const Pose2& recorded, const std::vector<ScanPoint>& scan,
                           const std::vector<TrackedPoint>& tracked,
                           const std::optional<Pose2>& moved) {
  const bool first = scans_++ == 0;
  const Pose2 before = first ? recorded : pose_;
  const Pose2 motion = first ? Pose2{} : between(recorded_, recorded);
  unheld_.reset();
  const MotionPrior prior{before, noise_.factor(motion)};
  if (!first) variance_ = noise_.sigma(motion).cwiseAbs2().asDiagonal();
  std::optional<Pose2> matched;
  if (!first && moved) {
    variance_ = followedSigma(*moved).cwiseAbs2().asDiagonal();
    matched = before * *moved;
  } else if (!first) {
    matched = has_tracks_ ? followedPose(tracked, motion, prior) : matchedPose(scan, motion, prior);
  }
  followed_ = matched && (moved || has_tracks_);
  has_tracks_ = has_tracks_ || !tracked.empty();
  pose_ = matched.value_or(before * prior.motion.motion);
  travelled_m_ += (pose_.position() - before.position()).norm();
  recorded_ = recorded;
  tracks_.add(tracked, pose_, travelled_m_);
  if (!has_tracks_) keep(scan);
  return matched.has_value();
}

std::optional<Pose2> LocalMapOdometry::followedPose(const std::vector<TrackedPoint>& tracked,
                                                    const Pose2& motion, const MotionPrior& prior) {
  const auto match = tracks_.match(tracked, prior);
  if (!match) return std::nullopt;
  noise_.learn(motion, between(prior.from, match->pose), kLeastScaleFollowed);
  variance_ = strayOf(*match, prior.motion);
  return match->pose;
}

std::optional<Pose2> LocalMapOdometry::matchedPose(const std::vector<ScanPoint>& scan,
                                                   const Pose2& motion, const MotionPrior& prior) {
  const auto match = bestMatch(scan, prior);
  if (!match || match->matched < kLeastMatched) return std::nullopt;
  noise_.learn(motion, between(prior.from, match->pose), kLeastScale);
  if (guessed_) return whereHeld(*match, prior);
  const Eigen::Vector3d off = prior.motion.at(prior.from, match->pose).residual;
  if (std::abs(off.z()) > kTurnSigmas) return std::nullopt;
  if (off.head<2>().squaredNorm() > kMoveSquare) return std::nullopt;
  variance_ = strayOf(*match, prior.motion);
  return match->pose;
}

/// Along a direction that only chance holds the guess goes on (solution remapping: Zhang, Kaess and
/// Singh 2016).
Pose2 LocalMapOdometry::whereHeld(const ScanMatch& match, const MotionPrior& prior) {
  unheld_ = unheldOf(match);
  if (!unheld_) return match.pose;
  const Vec2 guess = prior.from.toOuter(prior.motion.motion.position());
  const Vec2 at = match.pose.position();
  const Vec2 held = at + unheld_->dot(guess - at) * *unheld_;
  return {held.x(), held.y(), match.pose.heading};
}

void LocalMapOdometry::keep(const std::vector<ScanPoint>& scan) {
  if (kept_at_) {
    const Pose2 since = between(*kept_at_, pose_);
    if (since.position().norm() < kKeep_m && std::abs(since.heading) < odometry::kKeyframeTurn)
      return;
  }
  kept_at_ = pose_;
  kept_.push_back({scans_, travelled_m_});
  while (kept_.front().travelled_m < travelled_m_ - kWindow_m) kept_.pop_front();
  map_.dropBefore(kept_.front().number);
  map_.add(moved(scan, pose_), scans_);
}

}  // namespace handmap
