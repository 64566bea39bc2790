// The ground in front of a stereo camera.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/perception/camera_rays.h"

namespace handmap {

/// Plane in the levelled frame of the camera (see CameraRays).
struct GroundPlane {
  double height = 0.0;   ///< below the camera, metres
  double slope_x = 0.0;  ///< forward
  double slope_y = 0.0;  ///< to the left
  double at(double x, double y) const { return height + slope_x * x + slope_y * y; }
};

/// Robust least squares over what is near and low, held by the mount (z = 0) where little ground is
/// seen. `disparity` in pixels of `camera`, ≤ 0 where unknown.
GroundPlane fitGround(const cv::Mat1f& disparity, const StereoCamera& camera,
                      const CameraRays& rays);

}  // namespace handmap
