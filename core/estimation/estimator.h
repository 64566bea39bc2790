// The estimator: finds buildings and the robot's trajectory together, then tells which drawn
// building each found one is. README.md tells its story.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/shared_list.h"
#include "core/estimation/constants.h"
#include "core/estimation/labels/assignment.h"
#include "core/estimation/walls/wall_detection.h"
#include "core/map/map.h"
#include "core/perception/local_map.h"
#include "core/recording/observation.h"
#include "core/recording/trajectory.h"

namespace handmap {

struct EstimatorOptions {
  double range_limit_m = kUsualReach_m;
  int particles = estimation::kParticles;
  AssignmentOptions assignment;
};

/// A sample of where the robot is.
struct PoseParticle {
  Pose2 pose;
  double weight = 0.0;
};

/// Samples of what a drawn building is: as many hold a hypothesis of the buildings as its weight
/// says.
struct BuildingSwarm {
  std::size_t building;  ///< of the drawing
  std::vector<Rectangle> members;
};

/// A drawn building near the robot, as it is corrected now.
struct NearbyBuilding {
  std::size_t building;  ///< of the drawing
  Polygon outline;
  bool found;  ///< something that was seen is taken for it
};

/// What a step does, in this order; an observation near the last key frame ends with the first.
enum class EstimatorPhase { Way, Poses, Evidence, Detection, Labels, Correction };

class HandmapEstimator {
 public:
  /// The drawing needs buildings and a start pose. Throws BadInput otherwise.
  HandmapEstimator(const Map& drawing, const EstimatorOptions& options, std::uint64_t seed);
  ~HandmapEstimator();
  HandmapEstimator(const HandmapEstimator&) = delete;
  HandmapEstimator& operator=(const HandmapEstimator&) = delete;

  /// Odometry of the drawing's start, where the first observation is made later on the way. Before
  /// the first step().
  void startFrom(const Odometry& odometry);
  /// Takes other odometry for all observations so far, in the same frame, with so many times the
  /// usual noise: the way is laid along it, and what was found moves with the frames that saw it.
  void reviseOdometry(const std::vector<Pose2>& odometry, double noise);
  /// One observation. Where `stop` is requested it leaves out what only makes the whole run better.
  void step(double time_s, const Odometry& odometry, const Scan& scan,
            const std::stop_token& stop = {}, const std::function<void(double)>& progress = {});
  /// Smooths the last frames (`most_kept`) once more and labels anew, after the last observation,
  /// as far as `stop` allows.
  void finish(const std::stop_token& stop = {});

  /// `watch` is called after each phase of the steps that follow, in their thread, and may look at
  /// everything below. Empty: nobody does.
  void watch(std::function<void(EstimatorPhase)> watch);

  const Pose2& pose() const;
  const Eigen::Matrix3d& poseCovariance() const;
  /// What is no longer worked on is as it was the last time.
  const SharedList<StampedPose>& trajectory() const;
  std::vector<PoseParticle> particles() const;
  /// Of the drawn buildings whose found one is in sight: `members` samples of each.
  std::vector<BuildingSwarm> swarms(std::size_t members) const;
  double effectiveSampleSize() const;
  int visibleBuildings() const;
  /// The drawing corrected: every building moved to the one found for it, with its estimate; those
  /// without one by what the others say of the whole drawing. A member "doubtful" tells how
  /// probable it is that the building is another one, or not there, where that is more than slight.
  Map refinedMap() const { return refinedMapLater()(); }
  /// The same, to be made later and in any thread.
  std::function<Map()> refinedMapLater() const;
  /// Likewise, every building by what the others say, as if it had not been found itself.
  std::function<Map()> predictedMapLater() const;
  std::vector<NearbyBuilding> nearby() const;
  /// How the drawing as a whole lies.
  const DrawingMotion& drawingMotion() const;
  const std::vector<FoundBox>& found() const;
  /// Which drawn building one of found() is.
  std::optional<std::size_t> drawnOf(FoundId found) const;
  /// The walls that the evidence around the robot tells now.
  std::vector<FoundWall> walls() const;
  /// That evidence, as far as it speaks for walls, in the robot's frame.
  LocalMap evidence() const;
  /// See FrameReport.
  double logLikelihood() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace handmap
