#include "core/paper/disc.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace handmap {

cv::Mat disc(double radius_px) {
  const int r = std::max(1, static_cast<int>(std::lround(radius_px)));
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * r + 1, 2 * r + 1});
}

}  // namespace handmap
