// What a run tells ROS: where the robot is on the drawing, and what the drawing became.
#pragma once

#include <QCborMap>
#include <QString>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/map/map.h"
#include "core/map/occupancy_grid.h"
#include "drivers/rosbridge/ros_client.h"

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

/// geometry_msgs/PoseWithCovarianceStamped; of x, y in metres and the heading in radians.
QCborMap poseMessage(const RosHeader& header, const Pose2& pose, const Eigen::Matrix3d& covariance);

/// Where a frame lies in another one at a time.
struct RosTransform {
  RosTime stamp;
  QString parent;
  QString child;
  Pose2 pose;
};
/// tf2_msgs/TFMessage
QCborMap transformsMessage(const std::vector<RosTransform>& transforms, RosVersion version);

/// diagnostic_msgs/DiagnosticArray of one status.
struct RosDiagnostic {
  enum class Level { Ok, Warn, Error };
  Level level = Level::Ok;
  QString name;
  QString message;
  std::vector<std::pair<QString, QString>> values;
};
QCborMap diagnosticMessage(const RosHeader& header, const RosDiagnostic& diagnostic);

/// nav_msgs/OccupancyGrid: 100 in a building, 0 elsewhere.
QCborMap gridMessage(const RosHeader& header, const OccupancyGrid& grid);

/// visualization_msgs/MarkerArray: an outline for each building, in place of all markers before.
QCborMap markersMessage(const RosHeader& header, const Map& map);

}  // namespace handmap
