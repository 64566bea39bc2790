// The stereo camera of a bag: rectified as its camera infos say.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/bag_import/bag_facts.h"
#include "core/recording/camera.h"

namespace handmap {

class BagCamera {
 public:
  /// `rectified`: whether the topics say that the images are. Throws BadInput for infos that are
  /// not those of a calibrated pair; `file` names them.
  BagCamera(const BagFacts& facts, const BagPlan& plan, bool rectified, const std::string& file,
            std::vector<std::string>& notes);

  const StereoCamera& camera() const { return camera_; }
  /// Throws BadInput for an image of another size.
  cv::Mat left(const cv::Mat& image) const { return remapped(image, left_); }
  cv::Mat right(const cv::Mat& image) const { return remapped(image, right_); }

 private:
  struct Maps {
    cv::Mat pixels;
    cv::Mat fractions;
  };
  static Maps mapsOf(const ros::CameraInfo& info);
  cv::Mat remapped(const cv::Mat& image, const Maps& maps) const;

  std::string file_;
  cv::Size size_;
  StereoCamera camera_;
  Maps left_;  ///< empty where the images are rectified
  Maps right_;
};

/// The pose of a camera (z ahead, x right, y down; or x ahead, z up) as a mount.
CameraMount mountOf(const Eigen::Isometry3d& camera, const cv::Matx33d& rectification);

}  // namespace handmap
