#include "core/bag_import/bag_camera.h"

#include <cmath>

#include <fmt/format.h>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/calibration.h"

namespace handmap {

namespace {

constexpr double kMostBaseline_m = 10.0;
constexpr double kSamePixel = 0.01;

bool isPlain(const ros::CameraInfo& info) {
  const bool no_distortion = std::all_of(info.distortion.begin(), info.distortion.end(),
                                         [](double k) { return k == 0.0; });
  return no_distortion && cv::norm(info.rectification - cv::Matx33d::eye()) < 1e-9;
}

StereoCamera cameraOf(const ros::CameraInfo& left, const ros::CameraInfo& right,
                      const std::string& file) {
  const cv::Matx34d& p = left.projection;
  const cv::Matx34d& q = right.projection;
  const auto refuse = [&](const std::string& found, const std::string& expected) {
    throwBadInput(file, "camera_info", found, expected);
  };
  const bool is_calibrated = p(0, 0) > 0.0 && p(1, 1) > 0.0 && left.size.area() > 0;
  if (!is_calibrated) refuse(phrase("no calibration"), phrase("that of both cameras"));
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

}  // namespace

CameraMount mountOf(const Eigen::Isometry3d& camera, const cv::Matx33d& rectification) {
  Eigen::Matrix3d rectified;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) rectified(r, c) = rectification(c, r);  // its inverse
  }
  const Eigen::Vector3d optical = camera.linear() * rectified.col(2);
  // Some name the camera's body, whose z is up.
  const Eigen::Vector3d ahead =
      std::abs(optical.z()) > 0.9 ? Eigen::Vector3d(camera.linear().col(0)) : optical;
  const Eigen::Vector3d at = camera.translation();
  return {at.x(), at.y(), at.z(), std::asin(std::clamp(-ahead.z(), -1.0, 1.0)),
          std::atan2(ahead.y(), ahead.x())};
}

BagCamera::BagCamera(const BagFacts& facts, const BagPlan& plan, bool rectified,
                     const std::string& file, std::vector<std::string>& notes)
    : file_(file) {
  if (!facts.left || !facts.right) {
    throwBadInput(file, "camera_info", phrase("no calibration"), phrase("that of both cameras"));
  }
  size_ = facts.left->size;
  camera_ = cameraOf(*facts.left, *facts.right, file);
  if (!rectified && !(isPlain(*facts.left) && isPlain(*facts.right))) {
    left_ = mapsOf(*facts.left);
    right_ = mapsOf(*facts.right);
  }
  const auto pose = facts.frames.poseIn(facts.base, facts.camera_frame);
  if (plan.sensor && !plan.ranges) {  // body: x ahead, z up
    camera_.mount = mountOf(*plan.sensor, cv::Matx33d::eye());
  } else if (pose) {
    camera_.mount = mountOf(*pose, facts.left->rectification);
  } else {
    camera_.mount.z = kDefaultCameraHeight;
    notes.push_back(
        phrase("nothing tells where the camera is: taken to look ahead, {:.2f} m above the ground",
               kDefaultCameraHeight));
  }
}

BagCamera::Maps BagCamera::mapsOf(const ros::CameraInfo& info) {
  Maps maps;
  if (info.model == "equidistant") {
    std::vector<double> distortion = info.distortion;
    distortion.resize(4, 0.0);
    cv::fisheye::initUndistortRectifyMap(info.matrix, distortion, info.rectification,
                                         info.projection, info.size, CV_16SC2, maps.pixels,
                                         maps.fractions);
  } else {
    std::vector<double> distortion = info.distortion;
    for (const std::size_t allowed :
         {std::size_t{4}, std::size_t{5}, std::size_t{8}, std::size_t{12}, std::size_t{14}}) {
      if (distortion.size() <= allowed) {
        distortion.resize(allowed, 0.0);
        break;
      }
    }
    cv::initUndistortRectifyMap(info.matrix, distortion, info.rectification,
                                info.projection.get_minor<3, 3>(0, 0), info.size, CV_16SC2,
                                maps.pixels, maps.fractions);
  }
  return maps;
}

cv::Mat BagCamera::remapped(const cv::Mat& image, const Maps& maps) const {
  if (image.size() != size_) {
    throwBadInput(file_, "", phrase("{} × {} pixels", image.cols, image.rows),
                  phrase("{} × {} pixels", size_.width, size_.height));
  }
  if (maps.pixels.empty()) return image;
  cv::Mat result;
  cv::remap(image, result, maps.pixels, maps.fractions, cv::INTER_LINEAR);
  return result;
}

}  // namespace handmap
