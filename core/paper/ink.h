// Ink on a page: what was drawn, without shadows, uneven light and printed squares.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

struct Ink {
  cv::Mat mask;            ///< 8 bit, 255: ink
  double stroke_px = 3.0;  ///< the usual width of a stroke
  bool dark_page = false;  ///< chalk or a white pencil
  bool any = false;
};

/// The edge of a page, which is no ink, pixels.
int marginOf(const cv::Size& page);

/// A share of the paper's brightness: fainter than any pencil.
inline constexpr double kLeastContrast = 0.1;

/// Of a straightened page; pen, pencil, coloured pen on light paper, or light on dark paper. What
/// differs less from the paper than `least_contrast` is none.
Ink separatedInk(const cv::Mat& page, double least_contrast = kLeastContrast);

}  // namespace handmap
