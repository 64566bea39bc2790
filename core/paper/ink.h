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

/// Of a straightened page; pen, pencil, coloured pen on light paper, or light on dark paper.
Ink separatedInk(const cv::Mat& page);

}  // namespace handmap
