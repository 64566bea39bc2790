#include "core/classification/equalization.h"

#include <array>
#include <cstdint>

#include <opencv2/core.hpp>

#include "core/recording/image_file.h"

namespace handmap {

cv::Mat equalized(const cv::Mat& image) {
  const cv::Mat1b grey = greyImage(image);
  std::array<int, 256> counts{};
  for (int row = 0; row < grey.rows; ++row) {
    const std::uint8_t* line = grey[row];
    for (int x = 0; x < grey.cols; ++x) ++counts[line[x]];
  }
  cv::Mat1b curve(1, 256);
  std::int64_t up_to = 0;
  for (int level = 0; level < 256; ++level) {
    up_to += counts[static_cast<std::size_t>(level)];
    curve(level) = cv::saturate_cast<std::uint8_t>(255.0 * static_cast<double>(up_to) /
                                                   static_cast<double>(grey.total()));
  }
  cv::Mat result;
  cv::LUT(image, curve, result);
  return result;
}

}  // namespace handmap
