// From the pixels and disparities of a mounted camera to metres.
#pragma once

#include <vector>

#include <opencv2/core/types.hpp>

#include "core/recording/camera.h"

namespace handmap {

/// The levelled frame of a camera: x forward along its heading (pitch taken out), y left, z up from
/// the robot's ground, metres. A pixel of depth Z lies at x = Z forward[row], y = Z left[column],
/// z = mount.z + Z up[row].
struct CameraRays {
  CameraRays(const StereoCamera& camera, cv::Size size);

  std::vector<double> forward;
  std::vector<double> up;
  std::vector<double> left;
};

/// The camera of the same view at another resolution; one pixel is `factor` old ones.
StereoCamera reducedCamera(const StereoCamera& camera, double factor_x, double factor_y);

}  // namespace handmap
