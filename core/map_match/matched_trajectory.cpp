#include "core/map_match/matched_trajectory.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/LU>

#include "core/estimation/buildings/constants.h"
#include "core/geometry/pose_covariance.h"
#include "core/map_match/constants.h"
#include "core/outlines/structure.h"
#include "core/trajectory/scan_match.h"

namespace handmap {

using namespace map_match;

MatchedTrajectory::MatchedTrajectory(const Map& map, const SeenFrames& seen)
    : start_(map.start.value()),
      start_sigma_(kStart_m, kStart_m, kStartTurn),
      seen_(seen),
      walls_(map),
      pose_(start_) {
  if (const auto& said = map.start_uncertainty) {
    start_sigma_ = {std::max(said->position, kLeastStart_m),
                    std::max(said->position, kLeastStart_m),
                    std::max(said->heading, kLeastStartTurn)};
  }
}

Eigen::Matrix3d MatchedTrajectory::guessedBetween(const Keyframe& from, const Keyframe& to) const {
  return guessedOf({trajectory_[from.observation], from.guessed},
                   {trajectory_[to.observation], to.guessed});
}

MotionFactor MatchedTrajectory::motion(const Keyframe& from, const Keyframe& to) const {
  const Pose2 driven = between(trajectory_[from.observation], trajectory_[to.observation]);
  return loosened({driven, noise_.sigmaOf(driven).cwiseInverse().asDiagonal()},
                  guessedBetween(from, to));
}

/// Of the pose of `to`, by the odometry since a keyframe.
Eigen::Matrix3d MatchedTrajectory::carried(const Keyframe& from, const Keyframe& to) const {
  const Pose2 driven = between(trajectory_[from.observation], trajectory_[to.observation]);
  Eigen::Matrix3d motion = guessedBetween(from, to);
  motion.diagonal() += noise_.sigmaOf(driven).cwiseAbs2();
  return swungBy(to.pose.position() - from.pose.position(), at_keyframe_) +
         turnedBy(from.pose.heading, motion);
}

void MatchedTrajectory::add(const std::vector<Pose2>& trajectory, const OdometryNoise& noise,
                            const Eigen::Matrix3d& guessed) {
  guessed_ = guessed;
  const bool changed =
      !(noise == noise_) ||
      (trajectory_.size() > 1 && trajectory[trajectory_.size() - 1] != trajectory_.back());
  const double last = travelled_m_.empty() ? 0.0 : travelled_m_.back();
  travelled_m_.push_back(
      trajectory_.empty()
          ? 0.0
          : last + between(trajectory[trajectory.size() - 2], trajectory.back()).position().norm());
  trajectory_ = trajectory;
  noise_ = noise;
  if (changed) optimize();
  work(trajectory_.size() - 1);
}

void MatchedTrajectory::lay(const std::vector<Pose2>& trajectory, const OdometryNoise& noise,
                            const std::stop_token& stop) {
  trajectory_ = trajectory;
  noise_ = noise;
  for (std::size_t i = 0; i < trajectory.size() && !stop.stop_requested(); ++i) {
    travelled_m_.push_back(
        i == 0 ? 0.0
               : travelled_m_.back() + between(trajectory[i - 1], trajectory[i]).position().norm());
    work(i);
  }
  finish(stop);
}

/// The newest observation; those after it are not looked at.
void MatchedTrajectory::work(std::size_t observation) {
  Keyframe now{observation, start_, guessed_, {}};
  if (keyframes_.empty()) {
    covariance_ = start_sigma_.cwiseAbs2().asDiagonal();
  } else {
    const Keyframe& before = keyframes_.back();
    now.pose = before.pose * between(trajectory_[before.observation], trajectory_[observation]);
    pose_ = now.pose;
    const bool far = travelled_m_.back() - travelled_m_[before.observation] >= kKeyframe_m ||
                     mayBeFar(guessedBetween(before, now));
    covariance_ = carried(before, now);
    if (!far) return;
  }
  layOnWalls(now, featuresAround(now, {kBehind_m, 0.0}), covariance_);
  keyframes_.push_back(now);
  optimize();
}

void MatchedTrajectory::finish(const std::stop_token& stop) {
  std::vector<std::vector<ScanPoint>> features;
  for (const Keyframe& keyframe : keyframes_) {
    if (stop.stop_requested()) return;
    features.push_back(featuresAround(keyframe, {kAside_m, kAside_m}));
  }
  for (int round = 0; round < kMostRounds; ++round) {
    const PoseGraph before = graph();
    Eigen::Matrix3d expected;
    for (std::size_t i = 0; i < keyframes_.size(); ++i) {
      if (stop.stop_requested()) return;
      if (i % kAlike == 0) expected = before.covariance(i + 1);
      layOnWalls(keyframes_[i], features[i], expected);
    }
    optimize();
    double moved = 0.0;
    for (std::size_t i = 0; i < keyframes_.size(); ++i) {
      moved = std::max(moved,
                       (keyframes_[i].pose.position() - before.poses()[i + 1].position()).norm());
    }
    if (moved < kStill_m) return;
  }
}

/// Straight things, in the frame of the keyframe, seen from where the robot was.
std::vector<ScanPoint> MatchedTrajectory::featuresAround(const Keyframe& keyframe,
                                                         const Window& window) const {
  const double here = travelled_m_[keyframe.observation];
  const auto& frames = seen_.frames();
  const auto first = std::partition_point(frames.begin(), frames.end(), [&](const SeenFrame& f) {
    return f.observation < travelled_m_.size() &&
           travelled_m_[f.observation] < here - window.behind_m;
  });
  const auto last = std::partition_point(first, frames.end(), [&](const SeenFrame& f) {
    return f.observation < travelled_m_.size() &&
           travelled_m_[f.observation] <= here + window.ahead_m;
  });
  std::vector<Pose2> poses(static_cast<std::size_t>(std::distance(first, last)) == 0
                               ? 0
                               : std::prev(last)->observation + 1);
  for (auto frame = first; frame != last; ++frame) {
    poses[frame->observation] =
        between(trajectory_[keyframe.observation], trajectory_[frame->observation]);
  }
  const PlacedRays placed = placeRays(std::span(first, last), poses);
  std::vector<ScanPoint> features;
  for (const PlacedRay& ray : placed.rays) {
    if (ray.echo != Echo::Tall || ray.structure != Structure::Straight) continue;
    const float facing = ray.nx * ray.dx + ray.ny * ray.dy;
    const double side = facing > 0.0F ? -1.0 : 1.0;
    features.push_back({ray.end(), side * Vec2(ray.nx, ray.ny)});
  }
  return thinned(features, kSpacing_m);
}

void MatchedTrajectory::layOnWalls(Keyframe& keyframe, const std::vector<ScanPoint>& features,
                                   const Eigen::Matrix3d& expected) {
  keyframe.on_walls.reset();
  const auto prior_root = rootOf(expected.inverse());
  if (!prior_root) return;
  const MotionPrior prior{Pose2{}, {keyframe.pose, *prior_root}};
  const PointMap& walls = walls_.around(keyframe.pose.position());
  const auto match = matchScan(features, walls, keyframe.pose, trajectory::kGates_m, prior);
  visible_ = 0;
  if (!match || match->matched < kLeastMatched) return;
  const auto root = rootInformation(*match, {buildings::kFloor_m, buildings::kFloor_m, kFloorTurn});
  if (!root) return;
  keyframe.on_walls = MotionFactor{match->pose, *root};
  visible_ = walls_.buildingsAt(moved(features, match->pose), kOnWall_m, kLeastOnWalls);
}

/// The first pose is the map.
PoseGraph MatchedTrajectory::graph() const {
  PoseGraph graph({Pose2{}});
  for (std::size_t i = 0; i < keyframes_.size(); ++i) {
    const Keyframe& keyframe = keyframes_[i];
    graph.addPose(keyframe.pose);
    if (i == 0) {
      graph.addEdge(
          {0, 1, {start_, start_sigma_.cwiseInverse().asDiagonal()}, trajectory::kKernel});
    } else {
      graph.addEdge({i, i + 1, motion(keyframes_[i - 1], keyframe), trajectory::kKernel});
    }
    if (keyframe.on_walls) graph.addEdge({0, i + 1, *keyframe.on_walls, trajectory::kKernel});
  }
  return graph;
}

void MatchedTrajectory::optimize() {
  if (keyframes_.empty()) return;
  PoseGraph poses = graph();
  poses.optimize();
  for (std::size_t i = 0; i < keyframes_.size(); ++i) keyframes_[i].pose = poses.poses()[i + 1];
  const Keyframe& last = keyframes_.back();
  const std::size_t newest = travelled_m_.size() - 1;
  pose_ = last.pose * between(trajectory_[last.observation], trajectory_[newest]);
  at_keyframe_ = poses.covariance(keyframes_.size());
  covariance_ = carried(last, {newest, pose_, guessed_, {}});
}

/// Between two keyframes by both, each the more the nearer it is.
Pose2 MatchedTrajectory::corrected(std::size_t observation, std::size_t keyframe) const {
  const auto from = [&](const Keyframe& k) {
    return k.pose * between(trajectory_[k.observation], trajectory_[observation]);
  };
  const Keyframe& before = keyframes_[keyframe];
  if (keyframe + 1 == keyframes_.size()) return from(before);
  const Keyframe& after = keyframes_[keyframe + 1];
  const double whole = travelled_m_[after.observation] - travelled_m_[before.observation];
  const double done = travelled_m_[observation] - travelled_m_[before.observation];
  return interpolated(from(before), from(after), done / whole);
}

std::vector<Pose2> MatchedTrajectory::poses() const {
  std::vector<Pose2> poses;
  std::size_t keyframe = 0;
  for (std::size_t i = 0; i < trajectory_.size(); ++i) {
    while (keyframe + 1 < keyframes_.size() && keyframes_[keyframe + 1].observation <= i) {
      ++keyframe;
    }
    poses.push_back(corrected(i, keyframe));
  }
  return poses;
}

}  // namespace handmap
