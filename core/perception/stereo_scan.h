// The rays of stereo views: walls, and how far every image column was looked through.
#pragma once

#include <vector>

#include "core/perception/camera_rays.h"
#include "core/perception/scan.h"

namespace handmap {

/// For every image column the farthest surface seen in it, levelled frame of the camera, metres:
/// what is seen over a hedge or a car has been looked through. Columns that saw nothing are left
/// out. `max_depth_m`: beyond it depth is too noisy to tell.
std::vector<Vec2> lookedThrough(const cv::Mat1f& disparity, const StereoCamera& camera,
                                const CameraRays& rays, double max_depth_m);

/// One ray a direction of half a degree, robot frame: the nearest wall there, or else free space as
/// far as it was looked through. Unlike a laser, a camera that finds nothing in a direction (a
/// saturated white wall) has not said that nothing is there: such directions have no ray.
Scan stereoScan(const std::vector<WallPoint>& walls, const std::vector<Vec2>& looked_through);

}  // namespace handmap
