// Maps of robots: the picture and text of ROS's map_server.
#pragma once

#include <array>
#include <filesystem>

#include "core/map/map.h"
#include "core/map/seen_ground.h"

namespace handmap {

inline constexpr double kRobotMapCell_m = 0.1;

/// Buildings black, all else white; NAME.yaml and NAME.pgm beside it. The origin is the lower left
/// corner, not turned. Throws BadInput for a map without buildings or too large for a picture.
void writeRobotMap(const Map& map, const std::filesystem::path& path);

/// A drawing of what is occupied: a building each piece of at least 4 m². Throws BadInput.
Map readRobotMap(const std::filesystem::path& path);

/// An occupancy grid and the picture that it is.
struct RobotGrid {
  std::filesystem::path image;  ///< a pixel a cell
  std::array<int, 2> cells{};   ///< columns and rows
  double cell_m = 0.05;
  Pose2 origin;  ///< of the lower left corner in the frame of the robot
  SeenGround ground;
};

/// PGM, or a PNG as recordings may have; the modes trinary, scale and raw. Throws BadInput, also
/// where nothing is occupied.
RobotGrid readRobotGrid(const std::filesystem::path& path);

/// Its picture under a drawing: `place` is its frame in that of the map. It remembers the robot's
/// frame (core/geodata/fleet_map.h).
Underlay underlayOf(const RobotGrid& grid, const Pose2& place);
}  // namespace handmap
