// The motion of a rectified stereo camera from points that it saw at two places.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/base/random.h"
#include "core/odometry/constants.h"
#include "core/recording/camera.h"

namespace handmap {

/// Pixels: column in the left image, row in both, column in the right image.
using StereoPixel = Eigen::Vector3d;

struct StereoMatch {
  StereoPixel before;
  StereoPixel now;
};

struct CameraMotion {
  /// From the camera's frame before to that of now; x right, y down, z forward, metres.
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  std::vector<std::size_t> inliers;  ///< of the matches
};

/// In the frame of the camera. The disparity must be > 0.
Eigen::Vector3d triangulated(const StereoCamera& camera, const StereoPixel& pixel);
/// The inverse; the point must be in front of the camera.
StereoPixel projected(const StereoCamera& camera, const Eigen::Vector3d& point);

/// Three-point RANSAC over what moves as one, then least squares with both places of every point
/// uncertain (maximum likelihood to first order; Cauchy weights against what is left of outliers).
/// nullopt where fewer than `min_share` of the matches agree on one motion, or too few for any.
/// `guess` is where the search starts.
std::optional<CameraMotion> estimateMotion(const StereoCamera& camera,
                                           const std::vector<StereoMatch>& matches,
                                           const Eigen::Isometry3d& guess, RandomStream random,
                                           double min_share = odometry::kMinShare);

}  // namespace handmap
