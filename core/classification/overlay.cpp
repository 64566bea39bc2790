#include "core/classification/overlay.h"

#include <opencv2/imgproc.hpp>

#include "core/classification/windows.h"

namespace handmap {

cv::Mat3b withCrosses(const cv::Mat& image, const cv::Mat1f& probabilities) {
  constexpr int kMargin = 4;
  constexpr int kFar = kWindow_px - 1 - kMargin;
  cv::Mat3b result;
  if (image.channels() == 3) {
    image.copyTo(result);
  } else {
    cv::cvtColor(image, result, cv::COLOR_GRAY2BGR);
  }
  // Dark below light: seen on any ground.
  for (const auto& [colour, width] :
       {std::pair{cv::Scalar(0, 0, 0), 3}, {cv::Scalar(0, 220, 255), 1}}) {
    for (int row = 0; row < probabilities.rows; ++row) {
      for (int column = 0; column < probabilities.cols; ++column) {
        if (!(probabilities(row, column) > 0.5F)) continue;
        const cv::Point at(column * kWindow_px, row * kWindow_px);
        cv::line(result, at + cv::Point(kMargin, kMargin), at + cv::Point(kFar, kFar), colour,
                 width, cv::LINE_AA);
        cv::line(result, at + cv::Point(kMargin, kFar), at + cv::Point(kFar, kMargin), colour,
                 width, cv::LINE_AA);
      }
    }
  }
  return result;
}

}  // namespace handmap
