// Calibration of a rectified stereo camera in the form of KITTI odometry.
#pragma once

#include <filesystem>
#include <string>

#include "core/recording/camera.h"

namespace handmap {

/// Height of the camera above the ground where a recording does not tell it, metres.
inline constexpr double kDefaultCameraHeight = 1.65;

/// Reads the lines `left` and `right` ("P0", "P1" …: the 12 numbers of a 3×4 projection matrix).
/// `mount` is the pose of the camera that the matrices count from (P0); the result holds that of
/// the left camera. Throws BadInput, also for a baseline that is not positive.
StereoCamera readCalibration(const std::filesystem::path& path, const std::string& left,
                             const std::string& right, const CameraMount& mount);

/// The text with the lines P0 and P1 that reads back as the same camera.
std::string formatCalibration(const StereoCamera& camera);

}  // namespace handmap
