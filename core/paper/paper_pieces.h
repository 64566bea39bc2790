// The pieces that strokes cut the paper into, and the strokes between two of them.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// The stroke between two pieces of paper, as a straight line.
struct PieceBorder {
  int a = 0, b = 0;  ///< the pieces on both sides, a < b
  cv::Point2d middle;
  double angle_rad = 0.0;  ///< 0 … π, of the line
  double length_px = 0.0;
  double bend_px = 0.0;  ///< rms of the stroke's middle off the line
};

struct PaperPieces {
  cv::Mat labels;  ///< int: of each pixel the piece that it belongs to or, as ink, is nearest to
  cv::Mat off_paper_px;           ///< float: of ink, how far the paper is
  std::vector<cv::Rect> box;      ///< of the paper itself; 0 is no piece
  std::vector<double> area;       ///< of the paper itself, pixels
  std::vector<cv::Point2d> mean;  ///< the middle of the paper itself
  std::vector<double> thickness;  ///< of the largest disc within
  std::vector<double> length;     ///< 4 σ along the longest axis
  std::vector<double> width;      ///< 4 σ across it
  std::vector<double> axis_rad;   ///< 0 … π
  std::vector<bool> at_edge;      ///< of the page: enclosed by no stroke
  std::vector<PieceBorder> borders;

  int count() const { return static_cast<int>(area.size()); }
};

/// `ink`: 255 where there is some. Borders are those of strokes, not of blots.
PaperPieces paperPieces(const cv::Mat& ink, double stroke_px);

/// Between two lines, 0 … π/2.
double angleBetween(double a_rad, double b_rad);

}  // namespace handmap
