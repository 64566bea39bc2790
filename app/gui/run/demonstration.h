// The bundled demonstration: a street drawn from memory, what it is in truth, and a simulated
// robot.
#pragma once

#include "app/gui/run/robot.h"
#include "drivers/virtual/virtual_rig_kind.h"

namespace handmap {

struct Demonstration {
  Map sketch;
  Robot robot;
};

Demonstration demonstration();
/// A pleasant pace to watch it, times the robot's clock.
inline constexpr double kDemonstrationSpeed = 10.0;

/// Built-in worlds, each with a sketch of it. The same seed gives the same.
Demonstration twoRowSimulation(std::uint64_t seed);
Demonstration campusSimulation(std::uint64_t seed);
Demonstration loopSimulation(std::uint64_t seed);
Demonstration quarterSimulation(std::uint64_t seed);
/// A live robot among two rows of buildings.
Demonstration liveSimulation(std::uint64_t seed, VirtualRigKind kind);
/// The robot drives through what the drawing might be in truth, according to its uncertainty.
/// Throws Error (BadInput) when the drawing has neither a start nor a route.
Robot simulationOfDrawing(const Map& drawing, std::uint64_t seed);

}  // namespace handmap
