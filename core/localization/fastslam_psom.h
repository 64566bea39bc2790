// FastSLAM with PSO-based mapping, as published (Matsuo & Miura, IROS 2012, Algorithm 1).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "core/localization/path.h"
#include "core/localization/swarm.h"
#include "core/perception/local_map.h"

namespace handmap {

/// A pose and a map. Maps share the swarms that they have not changed.
struct Particle {
  Pose2 pose;
  double weight = 0.0;  ///< normalized over the particles
  Path path;
  std::vector<std::shared_ptr<const Swarm>> map;  ///< one a drawn building; null: never seen
  int visible = 0;                                ///< buildings seen in the last step
  bool plausible = true;  ///< no seen buildings overlap, and the robot is in none
};

struct StepResult {
  double effective_sample_size = 0.0;
  int visible_buildings = 0;  ///< of the best particle
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
  /// thread.
  bool step(double time_s, const Pose2& odometry, const LocalMap& local_map,
            const std::stop_token& stop = {}, const std::function<void(double)>& progress = {});

  const std::vector<Particle>& particles() const { return particles_; }
  const Particle& best() const { return particles_[best_]; }
  const StepResult& lastStep() const { return last_step_; }
  /// The drawing with the best particle's buildings and their estimates.
  Map refinedMap() const;

 private:
  Particle advanced(const Particle& particle, std::uint32_t index, double time_s,
                    const Pose2& motion, const LocalMap& local_map) const;
  std::vector<std::size_t> visibleBuildings(const Particle& particle, double range_m) const;
  std::shared_ptr<const Swarm> refinedSwarm(const Particle& particle, std::uint32_t index,
                                            std::size_t building, const LocalMap& local_map) const;
  BuildingState stateOf(const Particle& particle, std::size_t building) const;
  bool isPlausible(const Particle& particle, const std::vector<std::size_t>& buildings) const;
  void resample();
  Estimate estimateOf(std::size_t building, const Swarm& best) const;

  Map drawing_;
  SlamOptions options_;
  std::uint64_t seed_;
  std::vector<BuildingModel> models_;
  std::vector<Particle> particles_;
  std::size_t best_ = 0;
  Pose2 odometry_;           ///< of the last step
  std::uint32_t frame_ = 0;  ///< steps done
  StepResult last_step_;
};

}  // namespace handmap
