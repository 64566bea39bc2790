// Reads what a row of a recording names: images or points.
#pragma once

#include <filesystem>

#include "core/recording/recording.h"

namespace handmap {

class ViewReader {
 public:
  explicit ViewReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Both throw BadInput. All images must have the size of the first one read.
  void readImages(const FrameRow& row, View& view);
  void readPoints(const FrameRow& row, View& view) const;

 private:
  cv::Mat readSized(const std::string& name);

  std::filesystem::path folder_;
  cv::Size size_;
};

}  // namespace handmap
