// Images as they come from a camera that is not well.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

enum class FrameFault {
  None,
  WrongSize,  ///< another one than asked for, or than the first
  Half,       ///< the lower part never came
  Repeated    ///< to the byte the one before: no sensor is so still
};
std::string nameOf(FrameFault fault);

class FrameCheck {
 public:
  /// An empty size: that of the first image counts.
  explicit FrameCheck(cv::Size expected = {}) : expected_(expected) {}

  FrameFault operator()(const cv::Mat& image);
  /// So many were repeated, up to the newest.
  int repeatedInARow() const { return repeated_; }
  cv::Size expected() const { return expected_; }

 private:
  cv::Size expected_;
  cv::Mat before_;
  int repeated_ = 0;
};

/// So many repeated images are a camera that is frozen.
inline constexpr int kFrozen = 5;

}  // namespace handmap
