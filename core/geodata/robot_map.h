// Maps of robots: the picture and text of ROS's map_server.
#pragma once

#include <filesystem>

#include "core/map/map.h"

namespace handmap {

inline constexpr double kRobotMapCell_m = 0.1;

/// Buildings black, all else white; NAME.yaml and NAME.pgm beside it. The origin is the lower left
/// corner, not turned. Throws BadInput for a map without buildings or too large for a picture.
void writeRobotMap(const Map& map, const std::filesystem::path& path);

/// A drawing of what is occupied: a building each piece of at least 4 m². Throws BadInput.
Map readRobotMap(const std::filesystem::path& path);

}  // namespace handmap
