// What a run tells ROS: where the robot is on the drawing, and what the drawing became.
#pragma once

#include <QCborMap>
#include <QString>
#include <array>

#include "core/map/map.h"
#include "drivers/rosbridge/rosbridge_client.h"

namespace handmap {

/// A moment, since 1970, as ROS has it.
struct RosTime {
  std::int64_t seconds = 0;
  std::int64_t nanoseconds = 0;
};
RosTime rosTimeOf(double since_1970_s);

struct RosHeader {
  RosTime stamp;
  QString frame = QStringLiteral("map");
  RosVersion version = RosVersion::Ros2;
};

/// geometry_msgs/PoseWithCovarianceStamped; σ: x, y in metres, heading in radians.
QCborMap poseMessage(const RosHeader& header, const Pose2& pose,
                     const std::array<double, 3>& sigma);

/// nav_msgs/OccupancyGrid: 100 in a building, 0 elsewhere, a margin around. Cells are larger than
/// asked where there would be more than a million.
QCborMap gridMessage(const RosHeader& header, const Map& map, double cell_m = 0.25);

/// visualization_msgs/MarkerArray: an outline for each building, in place of all markers before.
QCborMap markersMessage(const RosHeader& header, const Map& map);

}  // namespace handmap
