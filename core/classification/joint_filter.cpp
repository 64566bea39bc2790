#include "core/classification/joint_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "core/classification/windows.h"

namespace handmap {

namespace {

constexpr float kNear = 2.0F;   // windows, standard deviation
constexpr float kLike = 15.0F;  // grey levels a channel, standard deviation
constexpr int kFarthest = 6;    // windows: three standard deviations

float squaredDistance(const float* a, const float* b, int channels) {
  float sum = 0.0F;
  for (int i = 0; i < channels; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

}  // namespace

cv::Mat1f jointlyFiltered(const cv::Mat1f& windows, const cv::Mat& image) {
  const cv::Rect whole(0, 0, windows.cols * kWindow_px, windows.rows * kWindow_px);
  const int channels = image.channels();
  cv::Mat mean;
  cv::resize(image(whole), mean, windows.size(), 0, 0, cv::INTER_AREA);
  mean.convertTo(mean, CV_32F);
  const auto colourOf = [&](int row, int column) {
    return mean.ptr<float>(row) + static_cast<std::ptrdiff_t>(column) * channels;
  };
  const float unlike = -0.5F / (kLike * kLike * static_cast<float>(channels));
  std::array<float, kFarthest + 1> far{};  // exponents
  for (std::size_t i = 0; i < far.size(); ++i) {
    far[i] = -0.5F * static_cast<float>(i * i) / (kNear * kNear);
  }
  cv::Mat1f result(windows.size());
  for (int row = 0; row < windows.rows; ++row) {
    for (int column = 0; column < windows.cols; ++column) {
      const float* own = colourOf(row, column);
      float sum = 0.0F;
      float weights = 0.0F;
      for (int y = std::max(row - kFarthest, 0); y <= std::min(row + kFarthest, windows.rows - 1);
           ++y) {
        const float in_height = far[static_cast<std::size_t>(std::abs(y - row))];
        for (int x = std::max(column - kFarthest, 0);
             x <= std::min(column + kFarthest, windows.cols - 1); ++x) {
          const float weight =
              std::exp(unlike * squaredDistance(own, colourOf(y, x), channels) + in_height +
                       far[static_cast<std::size_t>(std::abs(x - column))]);
          sum += weight * windows(y, x);
          weights += weight;
        }
      }
      result(row, column) = sum / weights;
    }
  }
  return result;
}

}  // namespace handmap
