#include "core/method/given_start.h"

#include <algorithm>
#include <cmath>

#include "core/base/gaussian.h"
#include "core/geometry/pose_covariance.h"
#include "core/method/constants.h"
#include "core/odometry/given_poses.h"
#include "core/pose_graph/pose_graph.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace method;

namespace {

Eigen::Matrix3d root(const Eigen::Vector3d& sigma) { return sigma.cwiseInverse().asDiagonal(); }

/// A place may be wrong where the heading is right.
void say(PoseGraph& graph, std::size_t pose, const Pose2& said, const Eigen::Vector3d& sigma,
         double kernel) {
  Eigen::Matrix3d place = root(sigma);
  Eigen::Matrix3d heading = Eigen::Matrix3d::Zero();
  std::swap(place(2, 2), heading(2, 2));
  graph.addEdge({0, pose, {said, place}, kernel});
  graph.addEdge({0, pose, {said, heading}, kernel});
}

}  // namespace

GivenStart::GivenStart(const Map& drawing, const SourceInfo& source, std::vector<StampedPose> given)
    : drawing_(drawing),
      start_odometry_(source.start_odometry),
      given_(std::move(given)),
      trajectory_({.range_limit_m = source.range_limit_m}) {}

void GivenStart::add(double time_s, const Odometry& odometry, const Percept& percept,
                     const std::stop_token& stop) {
  const bool is_first = trajectory_.recorded().empty();
  const Pose2 before = is_first ? odometry.pose : trajectory_.recorded().back();
  driven_m_ += between(before, odometry.pose).position().norm();
  trajectory_.add(time_s, odometry, percept, stop);
  wheels_.add(odometry);
  guessed_ = odometry.guessed;
  const double passed = is_first ? 0.0 : time_s - last_s_;
  while (!isDone() && given_[along_.size()].time_s <= time_s) {
    const double left = time_s - given_[along_.size()].time_s;
    const double share = passed > 0.0 ? std::max(0.0, 1.0 - left / passed) : 1.0;
    along_.push_back({trajectory_.recorded().size() - 1, share, driven_m_, trajectory_.covariance(),
                      wheels_.covariance()});
  }
  last_s_ = time_s;
}

/// What was guessed on the way by more than a hand is off is none that scans told.
bool GivenStart::isByScans() const {
  const Eigen::Vector3d hand = handSigma();
  return isDone() && trajectory_.usable() &&
         (guessed_.diagonal().array() <= hand.array().square()).all();
}

GivenStart::Way GivenStart::wayTo(const Along& along, bool by_scans) const {
  const auto& poses = by_scans ? trajectory_.scanPoses() : trajectory_.recorded();
  const std::size_t i = along.observation;
  const Pose2 pose = i == 0 ? poses.front() : interpolated(poses[i - 1], poses[i], along.share);
  Way way{between(start_odometry_, pose), by_scans ? along.by_scans : along.by_wheels};
  way.variance = turnedBy(-start_odometry_.heading, way.variance);
  way.variance.diagonal().array() += kLeastVariance;
  if (!by_scans) {
    way.variance.diagonal().head<2>().array() += std::pow(kWheelScale * along.driven_m, 2);
  }
  return way;
}

/// From the start as it was said to the first given pose.
bool GivenStart::mayDrift(const Way& way) const {
  const Pose2 there = between(*drawing_.start, given_.front().pose);
  const Eigen::Vector3d off(there.x - way.motion.x, there.y - way.motion.y,
                            normalizedAngle(there.heading - way.motion.heading));
  Eigen::Matrix3d variance = way.variance;
  variance.diagonal() += handSigma().cwiseAbs2();
  return off.dot(variance.inverse() * off) < kRareSquareOfThree;
}

Map GivenStart::drawing() const {
  const bool by_scans = isByScans();
  if (!by_scans && (along_.empty() || mayDrift(wayTo(along_.front(), false)))) return drawing_;
  const auto said = drawing_.start_uncertainty;
  const Eigen::Vector3d hand = handSigma();
  const Eigen::Vector3d before =
      said ? Eigen::Vector3d(said->position, said->position, said->heading) : hand;
  const std::size_t start = 1;  // 0 is the map's frame
  // Wheels lead no farther than to the next place that is told.
  const std::size_t last = by_scans ? along_.size() - 1 : 0;
  PoseGraph graph({{}, given_[last].pose * inverse(wayTo(along_[last], by_scans).motion)});
  say(graph, start, *drawing_.start, before.cwiseMax(std::sqrt(kLeastVariance)),
      trajectory::kKernel);
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t here = graph.poses().size();
    const Way way = wayTo(along_[i], by_scans);
    graph.addPose(graph.poses()[start] * way.motion);
    say(graph, here, given_[i].pose, hand, i == last ? kSaidLast : trajectory::kKernel);
    if (const auto information = rootOf(way.variance.inverse())) {
      graph.addEdge({start, here, {way.motion, *information}, kSaidLast});
    }
  }
  graph.optimize(kMostSteps);
  Map told = drawing_;
  told.start = graph.poses()[start];
  const Eigen::Matrix3d variance = graph.covariance(start);
  told.start_uncertainty = {std::sqrt(0.5 * variance.topLeftCorner<2, 2>().trace()),
                            std::sqrt(variance(2, 2))};
  return told;
}

}  // namespace handmap
