// The 16×16 pixel windows of section II-A that an image is judged by.
#pragma once

#include <algorithm>
#include <cstdint>

#include <opencv2/core/mat.hpp>

namespace handmap {

inline constexpr int kWindow_px = 16;

/// The whole windows of an image from its top left, numbered row by row.
struct WindowGrid {
  int columns = 0;
  int rows = 0;

  static WindowGrid of(cv::Size image) {
    return {image.width / kWindow_px, image.height / kWindow_px};
  }
  int count() const { return columns * rows; }
  /// The window of a pixel: x is the column, y the row. The pixels that are left over at the right
  /// and at the bottom belong to the last one; so do all beyond the image.
  cv::Point at(int x_px, int y_px) const {
    return {std::clamp(x_px / kWindow_px, 0, columns - 1),
            std::clamp(y_px / kWindow_px, 0, rows - 1)};
  }
};

/// Which windows of an image are wanted, rows × columns: none of them at first. Wanted ones are set
/// to any other value than 0, e.g. `wanted(WindowGrid::of(size).at(x, y)) = 1`.
inline cv::Mat1b noWindows(cv::Size image) {
  const WindowGrid grid = WindowGrid::of(image);
  return cv::Mat1b(grid.rows, grid.columns, std::uint8_t{0});
}

/// The value of a pixel's window, of one value a window (rows × columns, not empty).
inline float valueAt(const cv::Mat1f& windows, int x_px, int y_px) {
  return windows(WindowGrid{windows.cols, windows.rows}.at(x_px, y_px));
}

}  // namespace handmap
