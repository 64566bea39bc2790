// Images of a recording: PNG and JPEG, checked before anything is allocated for their pixels.
#pragma once

#include <filesystem>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// 8 bit, one or three channels, at most 64 megapixels. Throws BadInput for anything else, and for
/// a file that is missing, empty or cut off.
cv::Mat readImage(const std::filesystem::path& path);

/// Throws RunFailed.
void writePng(const cv::Mat& image, const std::filesystem::path& path);

}  // namespace handmap
