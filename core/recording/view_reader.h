// Reads what a row of a recording names: images or points.
#pragma once

#include <filesystem>

#include "core/recording/image_check.h"
#include "core/recording/recording.h"

namespace handmap {

class ViewReader {
 public:
  explicit ViewReader(const Recording& recording);

  /// Both throw BadInput. All images must have one size: that of the calibration where it tells
  /// one, else that of the first one read. A pair that nothing can be seen with (taken at two
  /// times, covered, overexposed, swapped) is refused. The views get rectified images.
  void readImages(const FrameRow& row, View& view);
  void readPoints(const FrameRow& row, View& view) const;

 private:
  cv::Mat readSized(const std::string& name);

  std::filesystem::path folder_;
  std::optional<StereoCamera> camera_;
  std::shared_ptr<const Rectifier> rectifier_;
  PointsReading points_as_;
  cv::Size size_;
  SwapCheck swap_check_;
};

}  // namespace handmap
