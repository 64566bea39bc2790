#include "core/trajectory/local_map_odometry.h"

#include <array>
#include <cmath>

namespace handmap {

namespace {

constexpr double kWindow_m = 100.0;  // of way: what was seen longer ago is out of sight
constexpr double kKeep_m = 0.8;
constexpr double kKeep = 0.15;  // radians
constexpr std::array kOdometryGates_m{1.5, 1.0, 0.7, 0.5, 0.5};
constexpr int kLeastMatched = 20;
constexpr double kTurnSigmas = 3.0;
constexpr double kMoveSquare = 18.0;  // in σ²

}  // namespace

bool LocalMapOdometry::add(const Pose2& recorded, const std::vector<ScanPoint>& scan) {
  const bool first = scans_++ == 0;
  const Pose2 before = first ? recorded : pose_;
  const Pose2 motion = first ? Pose2{} : between(recorded_, recorded);
  const MotionPrior prior{before, noise_.factor(motion)};
  const auto matched = first ? std::nullopt : matchedPose(scan, motion, prior);
  pose_ = matched.value_or(before * prior.motion.motion);
  travelled_m_ += (pose_.position() - before.position()).norm();
  recorded_ = recorded;
  keep(scan);
  return matched.has_value();
}

std::optional<Pose2> LocalMapOdometry::matchedPose(const std::vector<ScanPoint>& scan,
                                                   const Pose2& motion, const MotionPrior& prior) {
  const auto match =
      matchScan(scan, map_, prior.from * prior.motion.motion, kOdometryGates_m, prior);
  if (!match || match->matched < kLeastMatched) return std::nullopt;
  noise_.learn(motion, between(prior.from, match->pose));
  const Eigen::Vector3d off = prior.motion.at(prior.from, match->pose).residual;
  if (std::abs(off.z()) > kTurnSigmas) return std::nullopt;
  if (off.head<2>().squaredNorm() > kMoveSquare) return std::nullopt;
  return match->pose;
}

void LocalMapOdometry::keep(const std::vector<ScanPoint>& scan) {
  if (kept_at_) {
    const Pose2 since = between(*kept_at_, pose_);
    if (since.position().norm() < kKeep_m && std::abs(since.heading) < kKeep) return;
  }
  kept_at_ = pose_;
  kept_.push_back({scans_, travelled_m_});
  while (kept_.front().travelled_m < travelled_m_ - kWindow_m) kept_.pop_front();
  map_.dropBefore(kept_.front().number);
  map_.add(moved(scan, pose_), scans_);
}

}  // namespace handmap
