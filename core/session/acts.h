// What a person said while a robot drove, kept beside its recording, so that a replay does it
// again: `acts.jsonl`, one JSON object a line.
//
//   {"time_s":12.5,"act":"robot_is_here","x":1,"y":2,"heading_deg":90}
//   {"time_s":20,"act":"building_is_right","building":"L3","x":…,"y":…,"width":…,"depth":…,
//    "heading_deg":…}                                       or, of a polygon, "vertices":[[x,y],…]
//   {"time_s":31,"act":"building_is_not_there","building":"N1"}
//   {"time_s":40,"act":"forget_poses"}                      the robot_is_here of before
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

inline constexpr auto kActsFile = "acts.jsonl";

/// Map frame; metres, radians.
struct Act {
  enum class Kind { RobotIsHere, BuildingIsRight, BuildingIsNotThere, ForgetPoses };
  double time_s = 0.0;  ///< of the recording
  Kind kind = Kind::RobotIsHere;
  Pose2 pose;                                ///< RobotIsHere
  std::string building;                      ///< id; of the two about buildings
  std::variant<Rectangle, Polygon> shape{};  ///< BuildingIsRight
  bool operator==(const Act&) const = default;
};

/// Of a recording's folder, in the order of the file; none without the file. A last line that was
/// never finished is passed over. Throws BadInput "…/acts.jsonl: line 3: …: found …, expected …".
std::vector<Act> readActs(const std::filesystem::path& folder);
/// On the disk when it returns. Throws RunFailed with the reason of the system.
void appendAct(const std::filesystem::path& folder, const Act& act);
/// All of them, in place of those that the folder has.
void writeActs(const std::filesystem::path& folder, const std::vector<Act>& acts);

std::string formatAct(const Act& act);  ///< a line

}  // namespace handmap
