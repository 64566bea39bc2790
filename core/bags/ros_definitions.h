// The fields of the ROS 2 messages that are read and written, as MCAP and bridges tell them.
#pragma once

#include <string>

namespace handmap {

/// Of "geometry_msgs/msg/PoseStamped": its own fields, then those of each type within, behind a
/// line of "=". builtin_interfaces/Time is spelled out too: not every reader knows it.
std::string rosDefinition(const std::string& type);

/// As ROS 1 writes it: without "/msg".
std::string rosTypeName(std::string type);

}  // namespace handmap
