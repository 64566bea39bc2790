// What can be shown and hidden on the canvas.
#pragma once

#include <array>

#include "widgets/style/colours.h"

namespace handmap {

enum class Layer {
  Drawing,
  Underlays,
  Grid,
  LocalMap,
  Corrected,
  Band,
  Particles,
  Swarms,
  Trajectory,
  Odometry,
  Truth,
  Count
};

struct LayerSpec {
  Layer layer;
  const char* text;
  const char* hint;
  Role role;  ///< of its legend
};

/// In the order of the panel.
inline constexpr std::array<LayerSpec, static_cast<std::size_t>(Layer::Count)> kLayers = {{
    {Layer::Drawing, "Drawing", "The map as it is drawn", Role::Drawing},
    {Layer::Corrected, "Corrected map", "The best map of the run", Role::Corrected},
    {Layer::Band, "1-\u03c3 bands", "Where the corrected walls may be, one standard deviation",
     Role::CorrectedBand},
    {Layer::Particles, "Particles", "Where the robot may be; the surer, the stronger",
     Role::Particle},
    {Layer::Swarms, "Swarms", "What the buildings in sight may be: one outline a sample",
     Role::Swarm},
    {Layer::Trajectory, "Trajectory", "The way of the best particle", Role::Trajectory},
    {Layer::Odometry, "Odometry alone", "The way that the odometry alone would give",
     Role::Odometry},
    {Layer::LocalMap, "Local map", "The walls that the robot sees around itself", Role::LocalMap},
    {Layer::Truth, "Truth", "Where the recording knows the true way; never used by the run",
     Role::Truth},
    {Layer::Underlays, "Pictures", "Pictures below the drawing", Role::Axis},
    {Layer::Grid, "Grid", "The metric grid", Role::GridLineMajor},
}};

}  // namespace handmap
