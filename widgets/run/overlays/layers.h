// What can be shown and hidden on the canvas.
#pragma once

#include <QtGlobal>
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
  Changes,
  PoseSpread,
  Rays,
  Particles,
  Swarms,
  Trajectory,
  Odometry,
  Truth,
  Points,
  SeenWalls,
  Sight,
  Count
};

struct LayerSpec {
  Layer layer;
  const char* id;  ///< in settings
  const char* text;
  const char* hint;
  Role role;           ///< of its legend
  bool usual = true;   ///< shown before anybody has chosen
  bool of_run = true;  ///< there is nothing of it without a run
};

/// In the order of the panel.
inline constexpr std::array<LayerSpec, static_cast<std::size_t>(Layer::Count)> kLayers = {{
    {Layer::Drawing, "drawing", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Drawing"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "The map as it is drawn"), Role::Drawing, true,
     false},
    {Layer::Corrected, "corrected", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Corrected map"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "The best map of the run. Dashed: a wall that nobody saw. Hatched: a "
                       "doubtful building"),
     Role::Corrected},
    {Layer::Band, "bands", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Where walls may be"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "How sure each corrected wall is: two times of three it is within its band"),
     Role::CorrectedBand},
    {Layer::Changes, "changes", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Changes"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "From the drawn to the corrected place, and how far that is"),
     Role::Corrected},
    {Layer::PoseSpread, "ellipse",
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "Where the robot may be"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "How sure its place and its direction are: one standard deviation of each"),
     Role::Trajectory},
    {Layer::Rays, "rays", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Rays of a wall"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "What placed the wall that is asked about"),
     Role::LocalMap},
    {Layer::Particles, "particles", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Particles"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "Where the robot may be; the surer, the stronger"),
     Role::Particle, false},
    {Layer::Swarms, "swarms", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Swarms"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "What the buildings in sight may be: one outline a sample"),
     Role::Swarm, false},
    {Layer::Trajectory, "trajectory", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Way of the robot"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "Its way as the run has corrected it"),
     Role::Trajectory},
    {Layer::Odometry, "odometry", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Odometry alone"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "Its way as it measures its own motion, without the drawing"),
     Role::Odometry, false},
    {Layer::LocalMap, "local_map", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Local map"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "The walls that the robot sees around itself"),
     Role::LocalMap, false},
    {Layer::Points, "points", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Points"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "What the sensor sees now: strong where that is surely a wall"),
     Role::LocalMap, false},
    {Layer::SeenWalls, "seen_walls", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Visible walls"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "The parts of the corrected walls that the robot sees now"),
     Role::LocalMap, false},
    {Layer::Sight, "sight", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Visibility range"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "How far the sensor reaches, and what it looks through now"),
     Role::LocalMap, false},
    {Layer::Truth, "truth", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Truth"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel",
                       "Where the recording knows the true way; never used by the run"),
     Role::Truth, false, false},
    {Layer::Underlays, "pictures", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Pictures"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "Pictures below the drawing"), Role::Axis, true,
     false},
    {Layer::Grid, "grid", QT_TRANSLATE_NOOP("handmap::LayersPanel", "Grid"),
     QT_TRANSLATE_NOOP("handmap::LayersPanel", "The metric grid"), Role::GridLineMajor, true,
     false},
}};

}  // namespace handmap
