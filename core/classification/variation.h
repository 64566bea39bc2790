// Images as other cameras would have taken them, so that a classifier that learns from few cameras
// (or from rendered images) gets used to many.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/random.h"

namespace handmap {

/// The same image (8 bit, grey or BGR) with another exposure, contrast, white balance, sharpness
/// and noise. (Enlarged parts of the images did not help: they move the horizon.)
cv::Mat varied(const cv::Mat& image, RandomStream& random);

}  // namespace handmap
