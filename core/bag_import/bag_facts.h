// What is known of a bag before its images and points are read.
#pragma once

#include <string>
#include <vector>

#include "core/bag_import/bag_plan.h"
#include "core/bag_import/frame_tree.h"
#include "core/bags/ros_messages.h"
#include "core/recording/trajectory.h"

namespace handmap {

struct BagFacts {
  std::vector<StampedPose> odometry;  ///< increasing in time
  std::vector<StampedPose> truth;
  FrameTree frames;
  std::string base;  ///< the robot's frame
  std::optional<ros::CameraInfo> left, right;
  std::vector<double> left_s, right_s, ranges_s;  ///< stamps of their messages, in their order
  std::string camera_frame, ranges_frame;
  double reach_m = 0.0;
};

/// `notes` gets what was left out. Throws BadInput.
BagFacts factsOf(const Bag& bag, const BagPlan& plan, std::vector<std::string>& notes,
                 const std::stop_token& stop);

}  // namespace handmap
