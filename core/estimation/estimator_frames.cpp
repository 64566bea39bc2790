// Key frames, the trajectory through them, and how sure the newest pose is.
#include <algorithm>
#include <cmath>

#include "core/estimation/constants.h"
#include "core/estimation/estimator_state.h"
#include "core/geometry/pose_covariance.h"

namespace handmap {

using namespace estimation;

/// A motion between sights of nothing is told by the wheels alone, whatever tells the others.
double HandmapEstimator::State::noiseTo(std::size_t frame) const {
  return frame < kFromStart || frames[frame].blind ? 1.0 : odometry_noise;
}

void HandmapEstimator::State::addFrame(double time_s, const Odometry& odometry, const Pose2& at,
                                       const Scan& scan) {
  if (!scan.first_looked_at.empty() && !frames.empty()) {
    for (std::size_t i = firstKept(); i < frames.size(); ++i) {
      if (frames[i].ray_by_ray) addSilence(frames[i], scan.first_looked_at, sensor.rangeLimit());
    }
    evidence.reinsertAll();
  }
  frames.push_back(makeFrame(time_s, odometry.pose, at, scan));
  frames.back().guessed = odometry.guessed;
  frames.back().odometry_noise = noiseTo(frames.size() - 1);
  if (frames.size() > 1) {
    const Frame& before = frames[frames.size() - 2];
    frames.back().number = before.number + 1;
    frames.back().driven_m =
        before.driven_m + between(before.odometry, odometry.pose).position().norm();
  }
  frames.back().sightings = compactThings(frames.back().rays, sensor);
  landmarks.associate(frames.back(), sensor.measured().noise, kMostActive);
  if (const std::size_t kept = firstKept(); kept > 0) {
    frames[kept - 1].rays = {};
    frames[kept - 1].sightings = {};
  }
}

void HandmapEstimator::State::addObservation(double time_s, const Pose2& offset) {
  observations.push_back({time_s, frames.size() - 1, offset});
  poses.push_back({time_s, pose});
  trajectory = poses.share();
}

void HandmapEstimator::State::updateTrajectory() {
  for (std::size_t i = observations.size(); i-- > 0;) {
    const Observed& observed = observations[i];
    if (observed.frame < first_moved) break;
    poses.set(i, {observed.time_s, frames[observed.frame].pose * smoother.scaled(observed.offset)});
  }
  first_moved = frames.size();
  trajectory = poses.share();
}

std::size_t HandmapEstimator::State::firstActive() const {
  return frames.size() > kMostActive ? frames.size() - kMostActive : 0;
}

/// Older frames keep their pose alone.
std::size_t HandmapEstimator::State::firstKept() const {
  return frames.size() > kMostKept ? frames.size() - kMostKept : 0;
}

std::vector<Frame*> HandmapEstimator::State::framesFrom(std::size_t first) {
  std::vector<Frame*> some;
  for (std::size_t i = first; i < frames.size(); ++i) some.push_back(&frames[i]);
  return some;
}

MapCorrection::HasPassed HandmapEstimator::State::hasPassed() const {
  return [this](const Rectangle& box) {
    const Polygon corners = box.corners();
    const auto distance = [&](const Frame& frame) {
      return distanceTo(corners, frame.pose.position());
    };
    if (frames.empty()) return false;
    const double least = std::min(options.range_limit_m, distance(frames.back()));
    return std::ranges::any_of(frames, [&](const Frame& frame) { return distance(frame) < least; });
  };
}

/// The poses of the key frames along other odometry.
void HandmapEstimator::State::layAlong(const std::vector<Pose2>& odometry) {
  for (std::size_t i = 0; i < observations.size(); ++i) {
    Observed& observed = observations[i];
    Frame& frame = frames[observed.frame];
    if (i == 0 || observations[i - 1].frame != observed.frame) frame.odometry = odometry[i];
    observed.offset = between(frame.odometry, odometry[i]);
  }
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Frame& last = frames[i - 1];
    Frame& frame = frames[i];
    frame.odometry_noise = noiseTo(i);
    frame.pose = last.pose * smoother.scaled(between(last.odometry, frame.odometry));
  }
}

/// Buildings go with the frame in the middle of those that saw them, landmarks with the last one.
void HandmapEstimator::State::carryAlong(const std::vector<Pose2>& before) {
  const auto carried = [&](std::size_t frame, const Vec2& point) {
    return frames[frame].pose.toOuter(before[frame].toOwn(point));
  };
  const auto carry = [&](FoundBox& box) {
    const std::size_t last = std::min(box.last_frame, frames.size() - 1);
    const std::size_t middle = (std::min(box.first_frame, last) + last) / 2;
    box.box.pivot = carried(middle, box.box.pivot);
    box.box.heading += frames[middle].pose.heading - before[middle].heading;
  };
  for (FoundBox& box : found) carry(box);
  labels.changeSettled(carry);
  std::vector<bool> moved(landmarks.positions().size());
  for (std::size_t i = frames.size(); i-- > 0;) {
    for (const Sighting& sighting : frames[i].sightings) {
      const auto at = static_cast<std::size_t>(sighting.landmark);
      if (sighting.landmark < 0 || moved[at]) continue;
      landmarks.positions()[at] = carried(i, landmarks.positions()[at]);
      moved[at] = true;
    }
  }
}

/// What is known of the newest pose since frame `from`, which is itself uncertain.
void HandmapEstimator::State::carryCovariance(std::size_t from, const Eigen::Matrix3d& since) {
  covariances.resize(frames.size(), Eigen::Matrix3d::Zero());
  const Vec2 lever = frames.back().pose.position() - frames[from].pose.position();
  covariance = swungBy(lever, covariances[from]) + since;
  covariances.back() = covariance;
}

/// After all poses were smoothed together: the window's are no surer than the newest.
void HandmapEstimator::State::renewCovariance() {
  const auto newest = smoother.covariances({});
  if (!newest) return;
  covariance = *newest;
  covariances.resize(frames.size(), Eigen::Matrix3d::Zero());
  const auto count = std::min(covariances.size(), kWindow + 1);
  std::fill(covariances.end() - static_cast<std::ptrdiff_t>(count), covariances.end(), covariance);
}

}  // namespace handmap
