// FastSLAM with PSO-based mapping, as published (Matsuo & Miura, IROS 2012, Algorithm 1).
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "core/fastslam/line_sums.h"
#include "core/fastslam/path.h"
#include "core/fastslam/slam_trace.h"
#include "core/fastslam/swarm_map.h"
#include "core/recording/odometry.h"

namespace handmap {

/// A pose and a map.
struct Particle {
  Pose2 pose;
  double weight = 0.0;  ///< normalized over the particles
  Path path;
  SwarmMap map;           ///< by drawn building
  int visible = 0;        ///< buildings seen in the last step
  bool plausible = true;  ///< no seen buildings overlap, and the robot is in none
};

struct StepResult {
  double effective_sample_size = 0.0;
  int visible_buildings = 0;  ///< of the best particle
  double likelihood = 0.0;    ///< p(z_t): of the observation, all particles together
};

class FastSlamPsom {
 public:
  /// The drawing needs buildings and a start pose, the robot's pose where the odometry said
  /// `start_odometry`. Throws BadInput otherwise.
  FastSlamPsom(const Map& drawing, const Pose2& start_odometry, const SlamOptions& options,
               std::uint64_t seed);

  /// One observation: `odometry` in the odometry frame, `local_map` around the robot. Parallel in
  /// the caller's oneTBB arena; the result does not depend on the number of threads. Returns false
  /// and leaves the state as it was when `stop` was requested. `progress` may be called from any
  /// thread. `trace`: is told what happens in between.
  bool step(double time_s, const Odometry& odometry, const LocalMap& local_map,
            const std::stop_token& stop = {}, const std::function<void(double)>& progress = {},
            SlamTrace* trace = nullptr);

  const std::vector<Particle>& particles() const { return particles_; }
  const Particle& best() const { return particles_[best_]; }
  const StepResult& lastStep() const { return last_step_; }
  /// Buildings that any particle may have seen in the last step; ascending.
  const std::vector<std::size_t>& near() const { return near_; }
  /// At most `most` members of the swarm of a building in the best particle's map, evenly; empty
  /// where it was never seen.
  std::vector<Rectangle> swarmOf(std::size_t building, std::size_t most) const;
  /// The drawing with the best particle's buildings and their estimates.
  Map refinedMap() const;

 private:
  /// A building that one particle sees.
  struct Visible {
    std::size_t building;
    BuildingState state;  ///< the best after the step
    bool refined;         ///< false: as drawn
  };

  void scatter(const StartUncertainty& start);
  void samplePoses(double time_s, const Odometry& odometry);
  std::vector<std::size_t> byHeading() const;
  std::vector<std::size_t> buildingsNear(double range_m) const;
  void updateMap(Particle& particle, std::uint32_t index, double range_m,
                 const std::stop_token& stop, SlamTrace* trace);
  double refineBuilding(Particle& particle, std::uint32_t index, const Vec2& ahead, Visible& seen,
                        const std::stop_token& stop, SlamTrace* trace);
  SwarmWatch watchOf(std::size_t building, SlamTrace* trace) const;
  BuildingState stateOf(std::size_t building, const Swarm::Values& values) const;
  bool isPlausible(const Pose2& robot, const std::vector<Visible>& visible) const;
  void resample(SlamTrace* trace);
  Estimate estimateOf(std::size_t building, const Swarm& best) const;

  Map drawing_;
  SlamOptions options_;
  std::uint64_t seed_;
  std::vector<BuildingModel> models_;
  std::vector<std::size_t> by_x_;  ///< buildings, sorted by their drawn centres
  std::vector<std::size_t> near_;  ///< see near()
  LineSums sums_;                  ///< of the local map of this step
  std::vector<Particle> particles_;
  std::vector<Particle> next_;  ///< what a step works on; its memory is kept
  std::size_t best_ = 0;
  Odometry odometry_;        ///< of the last step
  std::uint32_t frame_ = 0;  ///< steps done
  /// No swarm of any particle was ever farther from its drawing than this, metres.
  std::atomic<double> farthest_moved_ = 0.0;
  StepResult last_step_;
};

}  // namespace handmap
