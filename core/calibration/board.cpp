#include "core/calibration/board.h"

#include <algorithm>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/text.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

constexpr std::int64_t kLeastCorners = 3;
constexpr std::int64_t kMostCorners = 50;
constexpr double kWindowShare = 0.35;  // of the distance of two corners, to either side
constexpr double kMaxWindow_px = 8.0;
constexpr int kGlimpseWidth_px = 640;

/// Halves the error of the detector at least, as far as no other corner is in the window.
void refine(const cv::Mat& grey, std::vector<cv::Point2f>& corners) {
  double spacing = kMaxWindow_px / kWindowShare;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    spacing = std::min(spacing, cv::norm(corners[i] - corners[i - 1]));
  }
  const int half = std::max(2, static_cast<int>(kWindowShare * spacing));
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 1e-3);
  cv::cornerSubPix(grey, corners, {half, half}, {-1, -1}, until);
}

}  // namespace

cv::Size parseBoardCorners(const std::string& text) {
  const auto sides = splitFields(text, 'x');
  const auto side = [&](std::size_t i) {
    const auto number = sides.size() == 2 ? parseInteger(sides[i]) : std::nullopt;
    const bool fits = number && *number >= kLeastCorners && *number <= kMostCorners;
    return fits ? static_cast<int>(*number) : 0;
  };
  const cv::Size corners(side(0), side(1));
  const bool fits = corners.width > 0 && corners.height > 0 && corners.width != corners.height;
  return fits ? corners : cv::Size();
}

std::vector<cv::Point2f> findCorners(const cv::Mat& image, const Board& board) {
  const cv::Mat grey = greyImage(image);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCornersSB(grey, board.corners, corners, cv::CALIB_CB_NORMALIZE_IMAGE)) {
    return {};
  }
  refine(grey, corners);
  return corners;
}

std::vector<cv::Point2f> glimpseCorners(const cv::Mat& image, const Board& board) {
  cv::Mat grey = greyImage(image);
  const double scale = std::max(1.0, static_cast<double>(grey.cols) / kGlimpseWidth_px);
  if (scale > 1.0) cv::resize(grey, grey, {}, 1.0 / scale, 1.0 / scale, cv::INTER_AREA);
  std::vector<cv::Point2f> corners;
  if (!cv::findChessboardCornersSB(grey, board.corners, corners, 0)) return {};
  const float to_centre = 0.5F;  // of a pixel, which is where its coordinates count from
  for (cv::Point2f& corner : corners) {
    corner.x = (corner.x + to_centre) * static_cast<float>(scale) - to_centre;
    corner.y = (corner.y + to_centre) * static_cast<float>(scale) - to_centre;
  }
  return corners;
}

void alignOrder(BoardView& view) {
  const cv::Point2f along = view.left.back() - view.left.front();
  const cv::Point2f other = view.right.back() - view.right.front();
  if (along.dot(other) < 0.0F) std::reverse(view.right.begin(), view.right.end());
}

double blurOf(const cv::Mat& image, const Board& board, const std::vector<cv::Point2f>& corners) {
  return cv::estimateChessboardSharpness(greyImage(image), board.corners, corners)[0];
}

}  // namespace handmap
