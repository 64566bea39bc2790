// Messages of ROS 2 as CDR.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/map/map.h"
#include "core/method/snapshot.h"
#include "core/perception/local_map.h"
#include "core/recording/camera.h"

namespace handmap::ros {

struct Stamp {
  double time_s = 0.0;
  std::string_view frame;
};

std::string transform(const Stamp& stamp, std::string_view child, const Pose2& pose);
std::string pose(const Stamp& stamp, const Pose2& pose);
std::string poseWithCovariance(const Stamp& stamp, const FrameReport& report);
std::string odometry(const Stamp& stamp, std::string_view child, const Pose2& pose);
/// A point a particle, its weight as intensity.
std::string particles(const Stamp& stamp, const std::vector<ParticleView>& particles);
/// Points along the walls, every 0.2 m.
std::string outlines(const Stamp& stamp, const Map& map);
/// A line and a name a building, coloured by its doubt.
std::string markers(const Stamp& stamp, const Map& map);
/// Around the robot: 0 … 100, how surely there is a wall.
std::string grid(const Stamp& stamp, const LocalMap& map);
std::string jpeg(const Stamp& stamp, const cv::Mat& image);
std::string cameraInfo(const Stamp& stamp, const StereoCamera& camera, cv::Size size);
/// Of rcl_interfaces/Log: 20 is information, 30 a warning.
std::string log(double time_s, int level, std::string_view text);
std::string numbers(const Stamp& stamp, const FrameReport& report);

}  // namespace handmap::ros
