// What in the numbers of a recording is likely not meant so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/recording/recording.h"

namespace handmap {

/// The same recording, read as it is likely meant.
struct Remedy {
  std::string name;  ///< "Read the points as millimetres"
  PointsReading points = {};
  double odometry_scale = 1.0;      ///< metres a unit
  bool clockwise_headings = false;  ///< of the odometry
  double odometry_turn = 0.0;       ///< radians, added to its headings
  double time_scale = 1.0;          ///< seconds a unit, of frames and odometry
  double range_limit_m = 0.0;       ///< 0: as it is
};

struct Doubt {
  std::string code;      ///< stable, for programs
  std::string message;   ///< FILE: PLACE: found …, expected …
  std::string hint;      ///< the likely cause, and what to do
  bool certain = false;  ///< it cannot be right: a run would be of no use
  std::optional<Remedy> remedy = {};
  double drawing_scale = 1.0;  ///< metres a unit of the drawing, where that is the doubt
};

using Doubts = std::vector<Doubt>;

/// A copy that is read so. Of several remedies one after the other.
Recording remedied(Recording recording, const Remedy& remedy);

}  // namespace handmap
