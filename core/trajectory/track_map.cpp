#include "core/trajectory/track_map.h"

#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

/// Of a look from `pose`, in the outer frame.
Eigen::Matrix2d covarianceOf(const Vec2& seen, const Pose2& pose) {
  const double range = seen.norm();
  const Vec2 along = (pose.toOuter(seen) - pose.position()) / range;
  const Vec2 aside = perpendicular(along);
  const double along_m = kLookInverseRange_per_m * range * range;
  const double aside_m = kLookBearing * range;
  return along_m * along_m * along * along.transpose() +
         aside_m * aside_m * aside * aside.transpose() +
         kLeastNoise_m * kLeastNoise_m * Eigen::Matrix2d::Identity();
}

}  // namespace

std::optional<ScanMatch> TrackMap::match(const std::vector<TrackedPoint>& seen,
                                         const MotionPrior& prior) const {
  std::vector<std::pair<const TrackedPoint*, const Landmark*>> known;
  for (const TrackedPoint& point : seen) {
    const auto landmark = landmarks_.find(point.id);
    if (landmark != landmarks_.end()) known.emplace_back(&point, &landmark->second);
  }
  if (known.size() < 3) return std::nullopt;  // two would never contradict each other
  ScanMatch match;
  match.pose = prior.from * prior.motion.motion;
  match.matched = static_cast<int>(known.size());
  for (const double kernel : kLookKernels) {
    for (int i = 0; i < kMatchSteps; ++i) {
      match.information.setZero();
      Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
      double squares = 1.0;  // as one residual more that is as the model has it
      double weights = 1.0;
      const ToOuter robot(match.pose);
      for (const auto& [point, landmark] : known) {
        const auto value = PointFactor{point->at, landmark->at, 1.0}.at(robot);
        const Eigen::Matrix2d certainty =
            (covarianceOf(point->at, match.pose) + landmark->covariance).inverse();
        const double square = value.residual.dot(certainty * value.residual);
        const double weight = cauchyWeight(square, kernel);
        match.information += weight * value.slope.transpose() * certainty * value.slope;
        gradient += weight * value.slope.transpose() * certainty * value.residual;
        squares += 0.5 * weight * square;
        weights += weight;
      }
      match.misfit = squares / weights;
      const Factor<3, 6> odometry = prior.motion.at(prior.from, match.pose);
      const Eigen::Matrix3d slope = odometry.jacobian.rightCols<3>();
      const double believed = cauchyWeight(odometry.residual.squaredNorm(), kKernel);
      gradient += believed * slope.transpose() * odometry.residual;
      const Eigen::Matrix3d both = match.information + believed * slope.transpose() * slope;
      const Eigen::Vector3d step = -Eigen::LDLT<Eigen::Matrix3d>(both).solve(gradient);
      if (!step.allFinite() || step.head<2>().norm() > kMostShift_m) return std::nullopt;
      match.pose = stepped(match.pose, step);
      if (step.head<2>().norm() < kStill_m && std::abs(step.z()) < kStill) break;
    }
  }
  return match;
}

void TrackMap::add(const std::vector<TrackedPoint>& seen, const Pose2& pose, double travelled_m) {
  std::erase_if(landmarks_, [&](const auto& landmark) {
    return landmark.second.travelled_m < travelled_m - kWindow_m;
  });
  for (const TrackedPoint& point : seen) {
    const Landmark look{pose.toOuter(point.at), covarianceOf(point.at, pose), travelled_m};
    const auto [found, is_new] = landmarks_.try_emplace(point.id, look);
    if (is_new) continue;
    Landmark& landmark = found->second;
    const Vec2 off = look.at - landmark.at;
    const Eigen::Matrix2d certainty = (look.covariance + landmark.covariance).inverse();
    if (off.dot(certainty * off) > kMoveSquare) {
      landmark = look;
      continue;
    }
    const Eigen::Matrix2d gain = landmark.covariance * certainty;
    landmark.at += gain * off;
    landmark.covariance -= gain * landmark.covariance;
    landmark.travelled_m = travelled_m;
  }
}

std::vector<ScanPoint> TrackMap::refined(const std::vector<TrackedPoint>& seen,
                                         const Pose2& pose) const {
  std::vector<ScanPoint> points;
  for (const TrackedPoint& point : seen) {
    ScanPoint refined;
    refined.at = pose.toOwn(landmarks_.at(point.id).at);
    refined.height = point.height;
    points.push_back(refined);
  }
  return points;
}

}  // namespace handmap
