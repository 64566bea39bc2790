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

  /// Where each pixel of a rectified image is in that of a lens; empty: the image comes rectified.
  struct Maps {
    cv::Mat pixels;     ///< CV_16SC2
    cv::Mat fractions;  ///< CV_16UC1
  };
  /// As somebody else has rectified it; the mount of `camera` is not looked at.
  Rectifier(cv::Size size, const StereoCamera& camera, Maps left, Maps right)
      : size_(size), camera_(camera), left_(std::move(left)), right_(std::move(right)) {}

  cv::Size size() const { return size_; }
  /// The camera behind the rectified images. `mount` is that of the rectified left camera: it looks
  /// at right angles to the baseline.
  StereoCamera camera(const CameraMount& mount) const;

  /// `image` must have size().
  cv::Mat left(const cv::Mat& image) const { return remapped(image, left_); }
  cv::Mat right(const cv::Mat& image) const { return remapped(image, right_); }

 private:
  static cv::Mat remapped(const cv::Mat& image, const Maps& maps);

  cv::Size size_;
  StereoCamera camera_;
  Maps left_;
  Maps right_;
};

}  // namespace handmap
