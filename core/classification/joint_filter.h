// Windows that look alike are probably the same thing.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Each window's value is averaged with those around it, by how near and how alike in colour they
/// are: a joint bilateral filter (Petschnigg et al., "Digital photography with flash and no-flash
/// image pairs", 2004), so that walls are filled and end where they end in the image. `windows`:
/// one value each of the whole windows of `image` (8 bit, grey or BGR), rows × columns.
cv::Mat1f jointlyFiltered(const cv::Mat1f& windows, const cv::Mat& image);

}  // namespace handmap
