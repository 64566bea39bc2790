// The paper's Table I: the processing time of a frame by the number of particles.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/experiments/report.h"

namespace handmap {

/// Particles of the published method; what its authors measured, seconds a frame.
struct Combination {
  int pso_particles;
  int slam_particles;
  double published_s;
};

/// The six of the paper, 10 iterations of a swarm.
const std::vector<Combination>& publishedCombinations();

/// What frames took here.
struct FrameTimes {
  Method method = Method::Paper;
  std::optional<Combination> combination;  ///< absent: Method::Handmap, without swarms
  std::vector<double> seconds;             ///< by frame, all of its stages
};

/// Drives through the scenes of seed, seed + 1, … with drawings that are 5 m off: with each
/// combination, and with our method. `threads`: of each run. Fewer where `stop` was requested.
std::vector<FrameTimes> measureTimes(std::uint64_t seed, int drives, int threads,
                                     const std::stop_token& stop,
                                     const std::function<void(int, int)>& progress = {});

Report timeReport(const std::vector<FrameTimes>& measured, int threads);

}  // namespace handmap
