// What a classifier found, for people to see.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// The image (grey or BGR, 8 bit) in colour, with a cross on every window judged to show a building
/// (p > 0.5), as in the paper's Fig. 2.
cv::Mat3b withCrosses(const cv::Mat& image, const cv::Mat1f& probabilities);

}  // namespace handmap
