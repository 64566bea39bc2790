// A plain KITTI odometry sequence folder: image_0|image_2, image_1|image_3, calib.txt, times.txt.
#pragma once

#include "core/recording/recording.h"

namespace handmap {

bool isKittiFolder(const std::filesystem::path& folder);

/// The camera is taken to be kDefaultCameraHeight above the ground, level. Truth: poses.txt or
/// poses_gt_kitti.txt. Odometry: odometry.tum or the first odometry*_kitti.txt; truth is never used
/// as odometry. Throws BadInput.
Recording openKittiFolder(const std::filesystem::path& folder, const std::stop_token& stop = {});

/// Increasing times, one a line. Throws BadInput.
std::vector<double> readKittiTimes(const std::filesystem::path& path);

/// Poses of 12 numbers a line (camera frame: x right, y down, z forward) at the given times, in the
/// robot frame, counted from the first of them.
Trajectory readKittiPoses(const std::filesystem::path& path, const std::vector<double>& times_s);

}  // namespace handmap
