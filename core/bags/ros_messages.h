// The ROS messages that tell something to a recording. The same fields in the same order in ROS 1
// and ROS 2, but for the number in front of the header of ROS 1. All throw BadInput.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/matx.hpp>

#include "core/bags/bag.h"
#include "core/recording/observation.h"

namespace handmap::ros {

struct Header {
  double stamp_s = 0.0;  ///< 0: not set
  std::string frame;     ///< without the slash that ROS 1 may begin it with
};
Header readHeader(FieldReader& fields, MessageEncoding encoding);

struct Pose {
  Header header;
  std::string child;  ///< of Odometry: the robot's frame
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};
/// nav_msgs/Odometry, geometry_msgs/PoseStamped, PoseWithCovarianceStamped.
Pose readPose(FieldReader fields, const BagTopic& topic);

/// tf2_msgs/TFMessage: each the pose of `child` in the frame of the header.
std::vector<Pose> readTransforms(FieldReader fields, const BagTopic& topic);

struct Points {
  Header header;  ///< of a scan: the time of its middle
  std::vector<RangePoint> points;
  double reach_m = 0.0;  ///< 0: not told
};
/// sensor_msgs/LaserScan, PointCloud2; in the sensor's frame.
Points readPoints(FieldReader fields, const BagTopic& topic);

struct CameraInfo {
  Header header;
  cv::Size size;
  std::string model;  ///< "plumb_bob", "rational_polynomial", "equidistant"
  std::vector<double> distortion;
  cv::Matx33d matrix;
  cv::Matx33d rectification;
  cv::Matx34d projection;
};
CameraInfo readCameraInfo(FieldReader fields, const BagTopic& topic);

/// What a sensor_msgs/Image holds.
struct PlainImage {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  std::size_t step = 0;  ///< bytes of a line
  std::string_view data;
};
cv::Mat imageOf(const PlainImage& plain, const std::string& source);

/// sensor_msgs/Image and CompressedImage, 8 bit: one channel, or three (blue first).
cv::Mat readImage(FieldReader fields, const BagTopic& topic);

bool isPose(const BagTopic& topic);
bool isTransforms(const BagTopic& topic);
bool isImage(const BagTopic& topic);
bool isScan(const BagTopic& topic);
bool isPointCloud(const BagTopic& topic);
bool isCameraInfo(const BagTopic& topic);

}  // namespace handmap::ros
