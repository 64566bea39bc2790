#include "core/paper/blots.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/paper/candidates.h"

namespace handmap {

namespace {

constexpr double kThick = 3.0;      // strokes wide: what is less may be one
constexpr double kStick = 6.0;      // length over width: a pen
constexpr double kBlotSolid = 0.8;  // of its convex hull

cv::Mat round(double radius) {
  const int r = std::max(1, static_cast<int>(std::lround(radius)));
  return cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * r + 1, 2 * r + 1});
}

bool isSolid(const std::vector<cv::Point>& outline) {
  std::vector<cv::Point> hull;
  cv::convexHull(outline, hull);
  return cv::contourArea(outline) > kBlotSolid * cv::contourArea(hull);
}

}  // namespace

Blots blotsOf(const Ink& ink, const PageScale& scale) {
  Blots blots;
  const double thick_px = std::max(kThick * scale.stroke_px, scale.least_px / 2.0);
  cv::Mat thick;
  cv::morphologyEx(ink.mask, thick, cv::MORPH_OPEN, round(thick_px / 2.0));
  blots.foreign = cv::Mat::zeros(thick.size(), CV_8U);
  const cv::Rect inner(2 * marginOf(thick.size()) + 2, 2 * marginOf(thick.size()) + 2,
                       std::max(0, thick.cols - 4 * marginOf(thick.size()) - 4),
                       std::max(0, thick.rows - 4 * marginOf(thick.size()) - 4));
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(thick, labels, stats, centres, 8);
  for (int i = 1; i < count; ++i) {
    const cv::Rect tight(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const cv::Rect box = cv::Rect(tight.x - 2, tight.y - 2, tight.width + 4, tight.height + 4) &
                         cv::Rect({0, 0}, thick.size());
    const cv::Mat mask = labels(box) == i;
    Region blot = regionOf(mask, box, 1.0);
    if (blot.outline.empty()) continue;
    const bool stick = blot.filled_area > kStick * blot.thickness * blot.thickness;
    if ((tight & inner) != tight || stick) {
      blots.foreign(box).setTo(255, mask);
    } else if (blot.thickness >= scale.least_px && isSolid(blot.outline)) {
      blots.filled.push_back(std::move(blot));
    }
  }
  cv::dilate(blots.foreign, blots.foreign, round(2.0 * scale.stroke_px));
  return blots;
}

}  // namespace handmap
