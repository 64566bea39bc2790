#include "core/recording/rectifier.h"

#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kMaxZoom = 4.0;  // of the focal length by rectification

}  // namespace

Rectifier::Rectifier(const StereoCalibration& calibration, const std::string& file)
    : size_(calibration.size) {
  const LensCalibration& left = calibration.left;
  const LensCalibration& right = calibration.right;
  cv::Matx33d r1;
  cv::Matx33d r2;
  cv::Matx34d p1;
  cv::Matx34d p2;
  cv::Matx44d q;
  // 0: no pixel outside of either image is seen.
  cv::stereoRectify(left.matrix, left.distortion, right.matrix, right.distortion, size_,
                    calibration.rotation, calibration.translation, r1, r2, p1, p2, q,
                    cv::CALIB_ZERO_DISPARITY, 0.0);
  const double zoom = p1(0, 0) / left.matrix(0, 0);
  if (!(zoom > 1.0 / kMaxZoom && zoom < kMaxZoom)) {
    throwBadInput(
        file, "", phrase("rectified images scaled by {:.3g}", zoom),
        phrase("a calibration that leaves both images about as they are: is it that of these "
               "cameras?"));
  }
  camera_ = {p1(0, 0), p1(1, 1), p1(0, 2), p1(1, 2), -p2(0, 3) / p2(0, 0), {}};
  const auto fill = [&](const LensCalibration& lens, const cv::Matx33d& r, const cv::Matx34d& p,
                        Maps& maps) {
    cv::initUndistortRectifyMap(lens.matrix, lens.distortion, r, p, size_, CV_16SC2, maps.pixels,
                                maps.fractions);
  };
  fill(left, r1, p1, left_);
  fill(right, r2, p2, right_);
}

StereoCamera Rectifier::camera(const CameraMount& mount) const {
  StereoCamera camera = camera_;
  camera.mount = mount;
  return camera;
}

cv::Mat Rectifier::remapped(const cv::Mat& image, const Maps& maps) {
  if (maps.pixels.empty()) return image;
  cv::Mat result;
  cv::remap(image, result, maps.pixels, maps.fractions, cv::INTER_LINEAR);
  return result;
}

}  // namespace handmap
