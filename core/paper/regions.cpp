#include "core/paper/regions.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/paper/disc.h"

namespace handmap {

namespace {

cv::Rect within(const cv::Rect& box, int border, const cv::Size& size) {
  return cv::Rect(box.x - border, box.y - border, box.width + 2 * border, box.height + 2 * border) &
         cv::Rect({0, 0}, size);
}

/// The outer outline of a mask alone, drawn full.
std::vector<cv::Point> fill(const cv::Mat& mask, cv::Mat& filled) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  filled = cv::Mat::zeros(mask.size(), CV_8U);
  if (contours.empty()) return {};
  const auto largest = std::ranges::max_element(
      contours, {}, [](const auto& contour) { return cv::contourArea(contour); });
  cv::drawContours(filled, contours, static_cast<int>(largest - contours.begin()), 255, cv::FILLED);
  return *largest;
}

}  // namespace

Region regionOf(const cv::Mat& mask, const cv::Rect& box, double stroke_px) {
  Region region;
  region.box = box;
  region.area = cv::countNonZero(mask);
  cv::Mat grown;
  cv::dilate(mask, grown, disc(stroke_px / 2.0));
  region.outline = fill(grown, region.filled);
  for (cv::Point& p : region.outline) p += box.tl();
  region.filled_area = cv::countNonZero(region.filled);
  cv::Mat distance;  // writing in it makes it no thinner
  cv::distanceTransform(region.filled, distance, cv::DIST_L2, 3);
  double most = 0.0;
  cv::minMaxLoc(distance, nullptr, &most);
  region.thickness = 2.0 * most - stroke_px;
  return region;
}

std::vector<Region> enclosedRegions(const cv::Mat& ink, double stroke_px, double least_px) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(~ink, labels, stats, centres, 4);
  const int border = static_cast<int>(std::ceil(2.0 * stroke_px)) + 2;
  std::vector<Region> regions;
  for (int i = 1; i < count; ++i) {
    const cv::Rect tight(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    const bool at_edge =
        tight.x <= 0 || tight.y <= 0 || tight.br().x >= ink.cols || tight.br().y >= ink.rows;
    if (at_edge || std::min(tight.width, tight.height) < least_px) continue;
    const cv::Rect box = within(tight, border, ink.size());
    Region region = regionOf(labels(box) == i, box, stroke_px);
    if (region.thickness >= least_px) regions.push_back(std::move(region));
  }
  return regions;
}

double shareWithin(const Region& part, const Region& whole) {
  const cv::Rect common = part.box & whole.box;
  if (common.empty() || part.filled_area <= 0.0) return 0.0;
  cv::Mat both;
  cv::bitwise_and(part.filled(common - part.box.tl()), whole.filled(common - whole.box.tl()), both);
  return cv::countNonZero(both) / part.filled_area;
}

}  // namespace handmap
