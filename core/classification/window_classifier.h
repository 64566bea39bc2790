// Whatever tells which windows of an image show a building.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// Immutable once made; any number of threads may use one.
class WindowClassifier {
 public:
  virtual ~WindowClassifier() = default;
  /// Rows × columns of the whole windows: the probability that the window shows a building. Windows
  /// that are not wanted, where `wanted` is given (same size, noWindows()), need not be judged:
  /// 0.5. `image`: 8 bit, grey or BGR, at least one window. Throws BadInput for another.
  virtual cv::Mat1f probabilities(const cv::Mat& image, const cv::Mat1b& wanted = {}) const = 0;
};

}  // namespace handmap
