// A checkerboard, and where a camera sees it.
#pragma once

#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

struct Board {
  cv::Size
      corners;  ///< inner ones, where four squares meet; different numbers in the two directions
  double square_m = 0.0;
};

/// Where both images of a pair show the corners, row by row, in the same order. Pixels.
struct BoardView {
  std::string name;  ///< of the images, without their ending
  std::vector<cv::Point2f> left;
  std::vector<cv::Point2f> right;
};

/// "9x6". Two different numbers from 3 to 50: a square board would not tell which side is up. An
/// empty size for anything else.
cv::Size parseBoardCorners(const std::string& text);

/// As exactly as they can be told; empty where the image does not show the whole board.
std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board);

/// Several times as fast, for a picture in motion: within a pixel or two, and a small board may be
/// missed.
std::vector<cv::Point2f> glimpseCorners(const cv::Mat& image, const Board& board);

/// A board that looks the same upside down may be numbered from either end: makes the right image
/// follow the left one.
void alignOrder(BoardView& view);

/// Pixels that an edge between two squares takes to go from dark to bright.
double blurOf(const cv::Mat& image, const Board& board, const std::vector<cv::Point2f>& corners);

}  // namespace handmap
