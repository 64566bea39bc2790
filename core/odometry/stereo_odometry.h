// The motion of a robot from what its stereo camera sees.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/geometry/pose2.h"
#include "core/odometry/camera_motion.h"
#include "core/odometry/corner_tracker.h"
#include "core/recording/camera.h"

namespace handmap {

struct VisualMotion {
  Pose2 motion;          ///< the robot now, in its own frame at the pair before
  int matches = 0;       ///< points seen at both places
  int inliers = 0;       ///< of them, those that agree on the motion
  bool guessed = false;  ///< too few agreed: the speed of before is taken to go on
};

/// Follows corners from a key pair to each pair after it, so that the errors of many short steps do
/// not add up; a pair that shares too little with the key pair is the next key pair. Moving things
/// do not matter as long as most of what is matched stands still. The same pairs and seed give the
/// same motions, to the byte.
class StereoOdometry {
 public:
  explicit StereoOdometry(const StereoCamera& camera, std::uint64_t seed = 1);

  /// Rectified, 8 bit, one or three channels, always of one size; `pan` as in View. nullopt for the
  /// first pair. Throws BadInput for images that cannot be used.
  std::optional<VisualMotion> operator()(const cv::Mat& left, const cv::Mat& right, double time_s,
                                         double pan = 0.0);

 private:
  struct KeyPair {
    TrackedPair images;
    Eigen::Isometry3d camera;  ///< pose of the camera in the robot frame
    Pose2 pose;                ///< of the robot
    std::vector<cv::Point2f> corners;
    std::vector<StereoPixel> pixels;  ///< of the corners
  };
  Eigen::Isometry3d cameraPose(double pan) const;
  /// Leaves the key as it is where too few corners are seen.
  void makeKey(TrackedPair images, const Eigen::Isometry3d& camera);
  std::vector<StereoMatch> matches(const TrackedPair& now, const Eigen::Isometry3d& guess) const;

  StereoCamera camera_;
  std::uint64_t seed_;
  std::uint32_t pairs_ = 0;
  cv::Size size_;
  std::optional<KeyPair> key_;
  Pose2 pose_;      ///< of the robot, from the first pair
  Pose2 velocity_;  ///< motion per second
  double time_s_ = 0.0;
};

}  // namespace handmap
