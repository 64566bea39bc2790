// The stereo camera that ROS tells of in two sensor_msgs/CameraInfo.
#pragma once

#include <string>

#include "core/bags/ros_messages.h"
#include "core/recording/rectifier.h"

namespace handmap::ros {

/// `rectified`: the images are. Throws BadInput for infos that are not those of a calibrated pair;
/// `source` names them.
Rectifier rectifierOf(const CameraInfo& left, const CameraInfo& right, bool rectified,
                      const std::string& source);

/// Whether a topic of images says in its name that they are rectified ("image_rect").
bool namesRectified(const std::string& topic);

/// Where what sends a topic of images tells of its camera: "/left/camera_info" of "/left/image_raw"
/// and of "/left/image_raw/compressed".
std::string cameraInfoTopic(std::string images);

}  // namespace handmap::ros
