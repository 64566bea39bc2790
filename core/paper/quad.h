// Four corners on a photo.
#pragma once

#include <array>

#include <opencv2/core/types.hpp>

namespace handmap {

/// Top left, top right, bottom right, bottom left.
using Quad = std::array<cv::Point2f, 4>;

}  // namespace handmap
