#include "core/bag_import/bag_camera.h"

#include <algorithm>
#include <cmath>

#include "core/bags/ros_camera.h"
#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/calibration.h"

namespace handmap {

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
    : file_(file), rectifier_(rectifierOf(facts, rectified, file)) {
  const auto pose = facts.frames.poseIn(facts.base, facts.camera_frame);
  if (plan.sensor && !plan.ranges) {  // body: x ahead, z up
    mount_ = mountOf(*plan.sensor, cv::Matx33d::eye());
  } else if (pose) {
    mount_ = mountOf(*pose, facts.left->rectification);
  } else {
    mount_.z = kDefaultCameraHeight;
    notes.push_back(
        phrase("nothing tells where the camera is: taken to look ahead, {:.2f} m above the ground",
               kDefaultCameraHeight));
  }
}

Rectifier BagCamera::rectifierOf(const BagFacts& facts, bool rectified, const std::string& file) {
  if (!facts.left || !facts.right) {
    throwBadInput(file, "camera_info", phrase("no calibration"), phrase("that of both cameras"));
  }
  return ros::rectifierOf(*facts.left, *facts.right, rectified, file);
}

void BagCamera::check(const cv::Mat& image) const {
  const cv::Size size = rectifier_.size();
  if (image.size() == size) return;
  throwBadInput(file_, "", phrase("{} × {} pixels", image.cols, image.rows),
                phrase("{} × {} pixels", size.width, size.height));
}

cv::Mat BagCamera::left(const cv::Mat& image) const {
  check(image);
  return rectifier_.left(image);
}

cv::Mat BagCamera::right(const cv::Mat& image) const {
  check(image);
  return rectifier_.right(image);
}

}  // namespace handmap
