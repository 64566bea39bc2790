// A robot that drives through a World and reports stereo images and odometry.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

#include "core/rendering/renderer.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

/// Where the camera looks at every step.
enum class Looking {
  Around,  ///< the robot stops for six pans, 60° apart: one panorama
  Ahead,   ///< the robot is on the move
};

/// What the pixels of each view of an observation show, in the order of its views.
using TruthListener = std::function<void(const Observation&, const std::vector<ImageTruth>&)>;

/// Drives as simulate() does with the same world, options and seed: truth and odometry are the
/// same. Images are rendered when next() asks for them. `listener` is told the truth of every
/// picture before it is handed out; it may be empty. After a `stop` was requested the source is at
/// its end. Throws BadInput for options that cannot be and where the map has no way to drive.
std::unique_ptr<ObservationSource> renderedSource(const World& world,
                                                  const SimulationOptions& simulation,
                                                  const RenderOptions& rendering, Looking looking,
                                                  std::uint64_t seed, TruthListener listener = {},
                                                  std::stop_token stop = {});

}  // namespace handmap
