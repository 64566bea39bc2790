#include "core/bags/ros_camera.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <opencv2/calib3d.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"

namespace handmap::ros {

namespace {

constexpr double kMostBaseline_m = 10.0;
constexpr double kSamePixel = 0.01;
constexpr std::string_view kCompressed = "/compressed";

bool isPlain(const CameraInfo& info) {
  const bool no_distortion = std::all_of(info.distortion.begin(), info.distortion.end(),
                                         [](double k) { return k == 0.0; });
  return no_distortion && cv::norm(info.rectification - cv::Matx33d::eye()) < 1e-9;
}

StereoCamera cameraOf(const CameraInfo& left, const CameraInfo& right, const std::string& source) {
  const cv::Matx34d& p = left.projection;
  const cv::Matx34d& q = right.projection;
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throwBadInput(source, "camera_info", found, expected);
  };
  const bool is_calibrated = p(0, 0) > 0.0 && p(1, 1) > 0.0 && !left.size.empty();
  if (!is_calibrated) refuse(phrase("no calibration"), phrase("that of both cameras"));
  const auto pixels = std::int64_t{left.size.width} * left.size.height;
  if (pixels > kMaxImagePixels) {
    refuse(phrase("{} × {} pixels", left.size.width, left.size.height),
           phrase("at most {} pixels", kMaxImagePixels));
  }
  if (left.size != right.size) {
    refuse(phrase("{} × {} pixels", right.size.width, right.size.height),
           phrase("{} × {} pixels", left.size.width, left.size.height));
  }
  for (const auto& [row, column] : {std::pair(0, 0), {1, 1}, {0, 2}, {1, 2}}) {
    if (std::abs(p(row, column) - q(row, column)) > kSamePixel) {
      refuse(phrase("P of the right camera: {:.3f}", q(row, column)),
             phrase("as the left one has it: {:.3f}", p(row, column)));
    }
  }
  const double baseline_m = (p(0, 3) - q(0, 3)) / p(0, 0);
  if (!(baseline_m > 0.0 && baseline_m < kMostBaseline_m)) {
    refuse(phrase("a baseline of {:.3g} m", baseline_m), phrase("the right camera to the right"));
  }
  return {p(0, 0), p(1, 1), p(0, 2), p(1, 2), baseline_m, {}};
}

/// As many coefficients as OpenCV knows a model of.
std::vector<double> distortionOf(const CameraInfo& info) {
  std::vector<double> distortion = info.distortion;
  for (const std::size_t allowed :
       {std::size_t{4}, std::size_t{5}, std::size_t{8}, std::size_t{12}, std::size_t{14}}) {
    if (distortion.size() > allowed) continue;
    distortion.resize(allowed, 0.0);
    break;
  }
  return distortion;
}

Rectifier::Maps mapsOf(const CameraInfo& info) {
  Rectifier::Maps maps;
  if (info.model == "equidistant") {
    std::vector<double> distortion = info.distortion;
    distortion.resize(4, 0.0);
    cv::fisheye::initUndistortRectifyMap(info.matrix, distortion, info.rectification,
                                         info.projection, info.size, CV_16SC2, maps.pixels,
                                         maps.fractions);
  } else {
    cv::initUndistortRectifyMap(info.matrix, distortionOf(info), info.rectification,
                                info.projection.get_minor<3, 3>(0, 0), info.size, CV_16SC2,
                                maps.pixels, maps.fractions);
  }
  return maps;
}

}  // namespace

Rectifier rectifierOf(const CameraInfo& left, const CameraInfo& right, bool rectified,
                      const std::string& source) {
  const StereoCamera camera = cameraOf(left, right, source);
  if (rectified || (isPlain(left) && isPlain(right))) return {left.size, camera, {}, {}};
  return {left.size, camera, mapsOf(left), mapsOf(right)};
}

bool namesRectified(const std::string& topic) {
  return topic.find("_rect") != std::string::npos || topic.find("/rect") != std::string::npos;
}

std::string cameraInfoTopic(std::string images) {
  if (images.ends_with(kCompressed)) images.resize(images.size() - kCompressed.size());
  const std::size_t slash = images.rfind('/');
  images.resize(slash == std::string::npos ? 0 : slash + 1);
  return images + "camera_info";
}

}  // namespace handmap::ros
