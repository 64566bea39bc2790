// The stereo camera of a bag: rectified as its camera infos say.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/bag_import/bag_facts.h"
#include "core/recording/camera.h"
#include "core/recording/rectifier.h"

namespace handmap {

class BagCamera {
 public:
  /// `rectified`: whether the topics say that the images are. Throws BadInput for infos that are
  /// not those of a calibrated pair; `file` names them.
  BagCamera(const BagFacts& facts, const BagPlan& plan, bool rectified, const std::string& file,
            std::vector<std::string>& notes);

  StereoCamera camera() const { return rectifier_.camera(mount_); }
  /// Throws BadInput for an image of another size.
  cv::Mat left(const cv::Mat& image) const;
  cv::Mat right(const cv::Mat& image) const;

 private:
  static Rectifier rectifierOf(const BagFacts& facts, bool rectified, const std::string& file);
  void check(const cv::Mat& image) const;

  std::string file_;
  Rectifier rectifier_;
  CameraMount mount_;
};

/// The pose of a camera (z ahead, x right, y down; or x ahead, z up) as a mount.
CameraMount mountOf(const Eigen::Isometry3d& camera, const cv::Matx33d& rectification);

}  // namespace handmap
