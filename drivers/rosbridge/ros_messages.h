// The ROS messages that tell something to a rig, out of what came over rosbridge. Stamps of ROS 1
// (secs, nsecs) and ROS 2 (sec, nanosec) are both understood. All throw BadInput.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/bags/ros_messages.h"
#include "core/geometry/pose2.h"
#include "core/recording/observation.h"
#include "drivers/rosbridge/ros_value.h"

namespace handmap {

/// nav_msgs/Odometry: the pose in the odometry frame, and what the two frames are called; empty
/// where it is not said.
struct RosOdometryMessage {
  double stamp_s = 0.0;
  Pose2 pose;
  std::string frame;
  std::string base;
};
RosOdometryMessage readOdometry(const RosValue& message);

/// geometry_msgs/PoseWithCovarianceStamped, as RViz's 2D Pose Estimate sends it.
struct RosPoseMessage {
  Pose2 pose;
  std::string frame;
};
RosPoseMessage readPose(const RosValue& message);

/// In the sensor's frame, w = 1.
struct RosPointsMessage {
  double stamp_s = 0.0;  ///< of the middle of the scan
  std::vector<RangePoint> points;
  /// Of a LaserScan: where nothing came back there is no point, and nothing is known from there on.
  std::optional<double> reach_m = {};
};
/// sensor_msgs/LaserScan; z = 0. What is no number, or nearer than its least range, was not
/// measured.
RosPointsMessage readLaserScan(const RosValue& message);
/// sensor_msgs/PointCloud2 with x, y, z as float32 or float64; at most 2 million points.
RosPointsMessage readPointCloud(const RosValue& message);

/// sensor_msgs/CompressedImage: PNG or JPEG; or sensor_msgs/Image; 8 bit.
struct RosImageMessage {
  double stamp_s = 0.0;
  cv::Mat image;
};
RosImageMessage readImage(const RosValue& message);

/// sensor_msgs/CameraInfo, without its header.
ros::CameraInfo readCameraInfo(const RosValue& message);

}  // namespace handmap
