// Pairs of images with which nothing can be seen, refused where they are read.
#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Throws BadInput for an image of a covered camera (black, or without any contrast) and for an
/// overexposed one (mostly saturated). 8 bit, one or three channels. Looks at some thousand pixels.
void checkPicture(const cv::Mat& image, const std::string& file);

/// Tells from the first pairs whether left and right are swapped: in rectified images nothing can
/// be farther right in the right image than in the left one.
class SwapCheck {
 public:
  /// Throws BadInput. Free once some pairs were seen to be right, or too many told nothing.
  void operator()(const cv::Mat& left, const cv::Mat& right, const std::string& file);

 private:
  int pairs_left_ = 12;  ///< to be looked at; one that is right counts for four
};

}  // namespace handmap
