// Makes the images of a stereo camera as it is into those of a rectified one.
#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

#include "core/recording/camera.h"
#include "core/recording/stereo_calibration.h"

namespace handmap {

/// Immutable once made: may be shared between threads.
class Rectifier {
 public:
  /// Throws BadInput where the calibration leaves no common view; `file` names it in messages.
  Rectifier(const StereoCalibration& calibration, const std::string& file);

  cv::Size size() const { return size_; }
  /// The camera behind the rectified images. `mount` is that of the rectified left camera: it looks
  /// at right angles to the baseline.
  StereoCamera camera(const CameraMount& mount) const;

  /// `image` must have size().
  cv::Mat left(const cv::Mat& image) const { return remapped(image, left_); }
  cv::Mat right(const cv::Mat& image) const { return remapped(image, right_); }

 private:
  struct Maps {
    cv::Mat pixels;     ///< CV_16SC2
    cv::Mat fractions;  ///< CV_16UC1
  };
  static cv::Mat remapped(const cv::Mat& image, const Maps& maps);

  cv::Size size_;
  StereoCamera camera_;
  Maps left_;
  Maps right_;
};

}  // namespace handmap
