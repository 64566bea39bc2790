// The image in another light.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// With every brightness about as frequent as any other (histogram equalization), so that exposure,
/// contrast and the time of day count for less. One curve for all channels: hues stay about the
/// same. `image`: 8 bit, grey or BGR, not empty.
cv::Mat equalized(const cv::Mat& image);

}  // namespace handmap
