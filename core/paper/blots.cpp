#include "core/paper/blots.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/median.h"
#include "core/paper/candidates.h"
#include "core/paper/disc.h"

namespace handmap {

namespace {

constexpr int kCoverSide_px = 450;    // what covers a page is seen from afar, too
constexpr double kCoverBroad = 0.01;  // of the longer side: half of a finger on A4
constexpr int kOtherColour = 14;  // of 128, in Lab; noise and a blue pen's strokes are less broad
constexpr double kOtherLight = 0.4;  // of the paper's
constexpr double kThick = 3.0;       // strokes wide: what is less may be one
constexpr double kStick = 6.0;       // length over width: a pen
constexpr double kBlotSolid = 0.8;   // of its convex hull

bool isSolid(const std::vector<cv::Point>& outline) {
  std::vector<cv::Point> hull;
  cv::convexHull(outline, hull);
  return cv::contourArea(outline) > kBlotSolid * cv::contourArea(hull);
}

}  // namespace

cv::Mat coverOf(const cv::Mat& page) {
  const double scale = kCoverSide_px / static_cast<double>(std::max(page.cols, page.rows));
  cv::Mat small, lab;
  cv::resize(page, small, {}, scale, scale, cv::INTER_AREA);
  cv::cvtColor(small, lab, cv::COLOR_BGR2Lab);
  std::vector<cv::Mat> channels;
  cv::split(lab, channels);
  std::array<double, 3> paper{};
  for (std::size_t i = 0; i < 3; ++i) {
    paper[i] = medianOf(std::vector<std::uint8_t>(channels[i].begin<std::uint8_t>(),
                                                  channels[i].end<std::uint8_t>()));
  }
  cv::Mat a, b;
  cv::absdiff(channels[1], cv::Scalar(paper[1]), a);
  cv::absdiff(channels[2], cv::Scalar(paper[2]), b);
  cv::Mat other = (cv::max(a, b) > kOtherColour) | (channels[0] < kOtherLight * paper[0]);
  cv::morphologyEx(other, other, cv::MORPH_OPEN, disc(kCoverBroad * kCoverSide_px));
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(other, labels, stats, centres, 8);
  for (int i = 1; i < count; ++i) {
    const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                       stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const bool at_edge =
        box.x <= 2 || box.y <= 2 || box.br().x >= other.cols - 2 || box.br().y >= other.rows - 2;
    if (!at_edge) other(box).setTo(0, labels(box) == i);
  }
  cv::Mat cover;
  cv::resize(other, cover, page.size(), 0, 0, cv::INTER_NEAREST);
  return cover;
}

Blots blotsOf(const Ink& ink, const PageScale& scale) {
  Blots blots;
  const double thick_px = std::max(kThick * scale.stroke_px, scale.least_px / 2.0);
  cv::Mat thick;
  cv::morphologyEx(ink.mask, thick, cv::MORPH_OPEN, disc(thick_px / 2.0));
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
  cv::dilate(blots.foreign, blots.foreign, disc(2.0 * scale.stroke_px));
  return blots;
}

}  // namespace handmap
