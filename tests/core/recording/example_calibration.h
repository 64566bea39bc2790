// A stereo camera that is not rectified: lenses that bend, one turned against the other.
#pragma once

#include <opencv2/calib3d.hpp>

#include "core/recording/stereo_calibration.h"

namespace handmap::test {

inline StereoCalibration exampleCalibration() {
  StereoCalibration calibration;
  calibration.size = {640, 480};
  calibration.left = {{520, 0, 325, 0, 522, 236, 0, 0, 1}, {-0.21, 0.07, 0.001, -0.0008, 0.0}};
  calibration.right = {{515, 0, 312, 0, 516, 245, 0, 0, 1}, {-0.19, 0.05, -0.0006, 0.0011, 0.0}};
  cv::Rodrigues(cv::Vec3d(0.012, -0.025, 0.018), calibration.rotation);
  calibration.translation = {-0.24, 0.004, 0.003};
  return calibration;
}

/// Where both cameras see a point of the left camera's frame.
struct PixelPair {
  cv::Point2d left;
  cv::Point2d right;
};

inline PixelPair seenBy(const StereoCalibration& calibration, const cv::Point3d& point) {
  const std::vector<cv::Point3d> points{point};
  std::vector<cv::Point2d> left;
  std::vector<cv::Point2d> right;
  cv::Vec3d turn;
  cv::Rodrigues(calibration.rotation, turn);
  cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), calibration.left.matrix,
                    calibration.left.distortion, left);
  cv::projectPoints(points, turn, calibration.translation, calibration.right.matrix,
                    calibration.right.distortion, right);
  return {left.front(), right.front()};
}

}  // namespace handmap::test
