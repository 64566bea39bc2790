// Images of a recording: PNG and JPEG, checked before anything is allocated for their pixels.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <opencv2/core/mat.hpp>

namespace handmap {

inline constexpr std::int64_t kMaxImagePixels = 64'000'000;

/// 8 bit, one or three channels, at most 64 megapixels. Throws BadInput for anything else, and for
/// a file that is missing, empty or cut off.
cv::Mat readImage(const std::filesystem::path& path);
/// The same of the bytes of such a file, from wherever; `name` stands for it in messages.
cv::Mat decodeImage(std::string_view bytes, const std::string& name);

inline constexpr std::int64_t kMaxPhotoPixels = 100'000'000;

/// A photo that a person took: three channels, the way up that its camera says, at most 100
/// megapixels, of which it is reduced by 2, 4 or 8 while its longer side stays at `side_px` or
/// more. Throws BadInput as readImage() does.
cv::Mat readPhoto(const std::filesystem::path& path, int side_px);
/// The same of the bytes of such a file.
cv::Mat decodePhoto(std::string_view bytes, const std::string& name, int side_px);

/// One channel; an image that has one already is not copied.
cv::Mat greyImage(const cv::Mat& image);

/// Throws RunFailed.
void writePng(const cv::Mat& image, const std::filesystem::path& path);

}  // namespace handmap
