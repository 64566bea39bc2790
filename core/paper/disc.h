// The element that masks are grown and thinned with.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Of so many pixels to the nearest whole, one at least.
cv::Mat disc(double radius_px);

}  // namespace handmap
