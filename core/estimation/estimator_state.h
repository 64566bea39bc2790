// What the estimator knows; for its own files only.
#pragma once

#include <deque>
#include <optional>

#include "core/estimation/buildings/box_finder.h"
#include "core/estimation/buildings/clutter_estimate.h"
#include "core/estimation/buildings/noise_estimate.h"
#include "core/estimation/constants.h"
#include "core/estimation/estimator.h"
#include "core/estimation/labels/labels.h"
#include "core/estimation/loops/loop_closure.h"
#include "core/estimation/map_correction.h"
#include "core/estimation/smoothing/landmarks.h"
#include "core/estimation/smoothing/odometry_estimate.h"
#include "core/estimation/smoothing/smoother.h"
#include "core/estimation/walls/active_directions.h"
#include "core/estimation/walls/evidence_window.h"
#include "core/odometry/constants.h"

namespace handmap {

struct HandmapEstimator::State {
  State(const Map& map, const EstimatorOptions& with, std::uint64_t random_seed)
      : drawing(map),
        options(with),
        seed(random_seed),
        sensor({}, with.range_limit_m),
        evidence(walls::kCell_m, 2.0 * (with.range_limit_m + estimation::kActive_m),
                 estimation::kActive_m, estimation::kMostActive, sensor),
        smoother(kWheels, sensor),
        odometry_estimate(kWheels.heading_variance_per_m),
        labels(drawing, with.assignment),
        correction(drawing, labels) {}

  /// Who looks sees the pose as it is by then; a step sets it at its end anyway.
  void reached(EstimatorPhase phase) {
    if (!watch) return;
    if (phase != EstimatorPhase::Way) pose = newestPose();
    watch(phase);
  }
  void process(const std::stop_token& stop, const std::function<void(double)>& progress);
  void workOn(const std::stop_token& stop, const std::function<void(double)>& progress);
  void workToTheEnd(const std::stop_token& stop, const std::function<void(double)>& progress = {});
  void addObservation(double time_s, const Pose2& offset);
  Pose2 newestPose() const {
    return frames.back().pose * smoother.scaled(observations.back().offset);
  }
  void updateTrajectory();
  double noiseTo(std::size_t frame) const;
  void addFrame(double time_s, const Odometry& odometry, const Pose2& at, const Scan& scan);
  void smoothWindow();
  void layAlong(const std::vector<Pose2>& odometry);
  void carryAlong(const std::vector<Pose2>& before);
  void carryCovariance(std::size_t from, const Eigen::Matrix3d& since);
  void renewCovariance();
  void updateDirections();
  void updateNoise();
  bool findBuildings();
  void followBuildings();
  bool closeLoop(const std::stop_token& stop);
  bool smoothPeriodically(const std::stop_token& stop);
  void smoothAll(std::span<const double> slacks, int iterations, std::span<const SameBuilding> same,
                 const std::stop_token& stop);
  void smoothToTheEnd(const std::stop_token& stop);
  std::optional<DriftPrior> possibleDrift() const;
  std::vector<FoundBox> allFound() const;
  void setAllFound(const std::vector<FoundBox>& all);
  void labelBuildings(double near_m);
  /// Buildings farther from the robot keep the labels that they have: no active frame sees them.
  double nearM() const {
    return estimation::kNearLimits * options.range_limit_m + estimation::kActive_m;
  }
  std::size_t firstActive() const;
  std::size_t firstKept() const;
  std::vector<Frame*> framesFrom(std::size_t first);
  bool isInReach(const FoundBox& found) const;
  bool isInSight(const FoundBox& found) const;
  MapCorrection::HasPassed hasPassed() const;

  /// What is still to be done of a key frame, first the one, then the other.
  enum class Due { Nothing, Buildings, Whole };

  Map drawing;
  EstimatorOptions options;
  std::uint64_t seed;
  SensorModel sensor;
  EvidenceWindow evidence;
  ActiveDirections directions;
  BoxFinder finder;
  Smoother smoother;

  std::deque<Frame> frames;  ///< key frames, in order of time
  std::vector<FoundBox> found;
  Landmarks landmarks;
  NoiseEstimate noise;
  ClutterEstimate clutter;
  OdometryEstimate odometry_estimate;
  Labels labels;
  MapCorrection correction;
  std::size_t smoothed_at = 0;  ///< frames when all were smoothed together
  int iterations_due = 0;       ///< of smoothing them all
  bool detected_last = false;   ///< walls, at the last key frame
  Due due = Due::Nothing;       ///< of the newest key frame
  bool between_frames = false;  ///< whether the last observation was no key frame
  struct Observed {             ///< an observation: its pose relative to a key frame
    double time_s;
    std::size_t frame;
    Pose2 offset;
  };
  std::vector<Observed> observations;
  SharedListWriter<StampedPose> poses;  ///< of the observations
  SharedList<StampedPose> trajectory;   ///< the same, to be shown
  std::size_t first_moved = 0;          ///< frame; those before stand where `poses` has them
  double odometry_noise = 1.0;
  Pose2 pose;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `pose`, given the start
  std::vector<Eigen::Matrix3d> covariances;              ///< the same by key frame, when it was new
  std::function<void(EstimatorPhase)> watch;
};

}  // namespace handmap
