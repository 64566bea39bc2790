// What programs that send fleets of robots about take: Open-RMF's building.yaml, and the
// reference_coordinates of its fleet adapters.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "core/map/map.h"

namespace handmap {

/// Of the map of a robot whose picture lies under a drawing.
struct RobotFrame {
  std::array<int, 2> cells{};  ///< columns and rows
  double cell_m = 0.05;
  Pose2 origin;  ///< of the lower left corner in the frame of the robot
};

/// In a member of the picture that this program otherwise does not know.
void rememberFrame(const RobotFrame& frame, Underlay& underlay);
/// Whether the picture of a robot's map lies under it.
bool hasRobotMap(const Map& map);

/// One level, in metres of the map (coordinate_system: cartesian_meters): a vertex each corner, a
/// wall between two, landmarks as named vertices. No lanes.
std::string formatBuildingYaml(const Map& map);

/// Where the corners of the robot's map lie in its own frame and, as it lies under the drawing, in
/// that of the map ("rmf"). Throws BadInput, which names `file`, where not just one lies under it.
std::string formatReferenceCoordinates(const Map& map, const std::filesystem::path& file);

}  // namespace handmap
