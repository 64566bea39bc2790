// Maps of robots: the picture and text of ROS's map_server.
#pragma once

#include <array>
#include <filesystem>

#include "core/map/map.h"
#include "core/map/seen_ground.h"

namespace handmap {

inline constexpr double kRobotMapCell_m = 0.1;

/// Metres: kRobotMapCell_m, or for a map that is too large for a picture of such cells the least of
/// 0.2, 0.5, 1, 2, 5, 10 that it fits in. `file` is what an error names. Throws BadInput for a map
/// without buildings, or too large even so.
double robotMapCell(const Map& map, const std::filesystem::path& file);

/// Buildings black, all else white, in cells of robotMapCell(); NAME.yaml and NAME.pgm beside it.
/// The origin is the lower left corner, not turned. Throws as robotMapCell() does.
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
