// What the ink encloses: the pieces of paper between the strokes.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

struct Region {
  cv::Rect box;    ///< on the page, with a border of some pixels
  cv::Mat filled;  ///< within the box: the region without its holes, to the strokes' middle
  std::vector<cv::Point> outline;  ///< of `filled`, on the page
  double area = 0.0;               ///< of the paper itself, pixels
  double filled_area = 0.0;
  double thickness = 0.0;  ///< of the largest disc between the strokes, pixels
  int parts = 1;           ///< pieces that it was put together from
};

/// Of a mask of paper within `box`.
Region regionOf(const cv::Mat& mask, const cv::Rect& box, double stroke_px);

/// Of the ink's holes, those of at least `least_px` thickness; what touches the page's edge is
/// none.
std::vector<Region> enclosedRegions(const cv::Mat& ink, double stroke_px, double least_px);

/// The share of `part` that lies in `whole`.
double shareWithin(const Region& part, const Region& whole);

}  // namespace handmap
