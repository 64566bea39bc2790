#include "core/paper/page.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/paper/sheet_marks.h"

namespace handmap {

namespace {

constexpr int kSearchSide_px = 600;
constexpr double kLeastShare = 0.2;    // of the photo: a smaller page is no photo of a page
constexpr double kLeastFilled = 0.93;  // of the four-sided outline
constexpr double kLeastRatio = 1.6;    // page to table; a shadow on one page is less
constexpr int kOnBorder_px = 3;

cv::Mat filledLargest(const cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat filled = cv::Mat::zeros(mask.size(), CV_8U);
  if (contours.empty()) return filled;
  const auto largest = std::ranges::max_element(
      contours, {}, [](const auto& contour) { return cv::contourArea(contour); });
  cv::drawContours(filled, contours, static_cast<int>(largest - contours.begin()), 255, cv::FILLED);
  return filled;
}

std::optional<std::vector<cv::Point>> fourCorners(const cv::Mat& filled) {
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(filled, contours, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  if (contours.empty()) return std::nullopt;
  std::vector<cv::Point> hull;
  cv::convexHull(contours.front(), hull);
  std::vector<cv::Point> corners;
  for (double share = 0.01; share < 0.1; share *= 1.25) {
    cv::approxPolyDP(hull, corners, share * cv::arcLength(hull, true), true);
    if (corners.size() == 4) return corners;
  }
  return std::nullopt;
}

Quad ordered(const std::vector<cv::Point>& corners, double scale) {
  Quad quad;
  for (std::size_t i = 0; i < 4; ++i) quad[i] = cv::Point2f(corners[i]) * static_cast<float>(scale);
  const cv::Point2f centre = (quad[0] + quad[1] + quad[2] + quad[3]) * 0.25f;
  // From the top left clockwise, as a person sees it.
  std::ranges::sort(
      quad, {}, [&](const cv::Point2f& p) { return std::atan2(p.y - centre.y, p.x - centre.x); });
  const auto first = std::ranges::min_element(quad, {}, [](const auto& p) { return p.x + p.y; });
  std::rotate(quad.begin(), first, quad.end());
  return quad;
}

bool isPage(const cv::Mat& filled, const std::vector<cv::Point>& corners, const cv::Mat& grey) {
  const double area = cv::contourArea(corners);
  if (area < kLeastShare * static_cast<double>(grey.total())) return false;
  if (cv::countNonZero(filled) < kLeastFilled * area) return false;
  const auto on_border = std::ranges::count_if(corners, [&](const cv::Point& p) {
    return std::min({p.x, p.y, grey.cols - 1 - p.x, grey.rows - 1 - p.y}) < kOnBorder_px;
  });
  if (on_border > 2) return false;
  const double inside = cv::mean(grey, filled)[0] + 1.0;
  const double outside = cv::mean(grey, ~filled)[0] + 1.0;
  return std::max(inside / outside, outside / inside) > kLeastRatio;
}

}  // namespace

std::optional<Quad> pageOutline(const cv::Mat& photo) {
  const double scale =
      std::max(1.0, std::max(photo.cols, photo.rows) / static_cast<double>(kSearchSide_px));
  cv::Mat grey;
  cv::resize(photo, grey, {}, 1.0 / scale, 1.0 / scale, cv::INTER_AREA);
  if (grey.channels() == 3) cv::cvtColor(grey, grey, cv::COLOR_BGR2GRAY);
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {15, 15});
  for (const bool bright : {true, false}) {
    cv::Mat plain;  // without the ink
    cv::morphologyEx(grey, plain, bright ? cv::MORPH_CLOSE : cv::MORPH_OPEN, disc);
    cv::Mat mask;
    cv::threshold(plain, mask, 0, 255,
                  cv::THRESH_OTSU | (bright ? cv::THRESH_BINARY : cv::THRESH_BINARY_INV));
    const cv::Mat filled = filledLargest(mask);
    const auto corners = fourCorners(filled);
    if (corners && isPage(filled, *corners, grey)) return ordered(*corners, scale);
  }
  return std::nullopt;
}

double aspectOf(const Quad& quad, const cv::Size& photo) {
  const auto length = [](const cv::Point2f& v) { return std::hypot(v.x, v.y); };
  const double across = length(quad[1] - quad[0]) + length(quad[2] - quad[3]);
  const double down = length(quad[3] - quad[0]) + length(quad[2] - quad[1]);
  const double plain = across / std::max(1.0, down);
  // Zhang and He, Whiteboard scanning and image enhancement (2004), equations 11, 14, 20: the
  // principal point is taken to be the middle of the photo.
  const cv::Vec3d centre(photo.width / 2.0, photo.height / 2.0, 0.0);
  const auto point = [&](std::size_t i) {
    return cv::Vec3d(quad[i].x - centre[0], quad[i].y - centre[1], 1.0);
  };
  const cv::Vec3d m1 = point(0), m2 = point(1), m3 = point(3), m4 = point(2);
  const double k2 = m1.cross(m4).dot(m3) / m2.cross(m4).dot(m3);
  const double k3 = m1.cross(m4).dot(m2) / m3.cross(m4).dot(m2);
  const cv::Vec3d n2 = k2 * m2 - m1;
  const cv::Vec3d n3 = k3 * m3 - m1;
  const double weak = 0.05;  // less perspective than that tells nothing of the focal length
  if (std::abs(k2 - 1.0) < weak || std::abs(k3 - 1.0) < weak) return plain;
  const double f2 = -(n2[0] * n3[0] + n2[1] * n3[1]) / (n2[2] * n3[2]);
  if (!(f2 > 0.0)) return plain;
  const auto size = [f2](const cv::Vec3d& n) {
    return std::sqrt((n[0] * n[0] + n[1] * n[1]) / f2 + n[2] * n[2]);
  };
  const double aspect = size(n2) / size(n3);
  return std::isfinite(aspect) && std::abs(std::log(aspect / plain)) < 0.7 ? aspect : plain;
}

Page straightened(const cv::Mat& photo, const Quad& quad, double aspect) {
  const auto side = [&](std::size_t a, std::size_t b) {
    return std::hypot(quad[a].x - quad[b].x, quad[a].y - quad[b].y);
  };
  const double longest = std::max({side(0, 1), side(1, 2), side(2, 3), side(3, 0)});
  const double most = std::clamp(longest, 16.0, static_cast<double>(kPageSide_px));
  aspect = std::clamp(aspect, 0.05, 20.0);
  const auto width = static_cast<float>(std::round(aspect >= 1.0 ? most : most * aspect));
  const auto height = static_cast<float>(std::round(aspect >= 1.0 ? most / aspect : most));
  const Quad target = {cv::Point2f{0, 0}, {width, 0}, {width, height}, {0, height}};
  Page page;
  const cv::Mat turn = cv::getPerspectiveTransform(quad.data(), target.data());
  page.from_photo = cv::Matx33d(turn);
  cv::warpPerspective(photo, page.image, turn, {static_cast<int>(width), static_cast<int>(height)},
                      cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  if (page.image.channels() == 1) cv::cvtColor(page.image, page.image, cv::COLOR_GRAY2BGR);
  return page;
}

Page pageOf(const cv::Mat& photo) {
  const auto width = static_cast<float>(photo.cols);
  const auto height = static_cast<float>(photo.rows);
  if (const auto seen = sheetOn(photo)) {
    Page page = straightened(photo, seen->grid, kSheetWidth_mm / kSheetHeight_mm);
    page.edges_found = true;
    page.sheet = seen->code;
    return page;
  }
  if (const auto quad = pageOutline(photo)) {
    Page page = straightened(photo, *quad, aspectOf(*quad, photo.size()));
    page.edges_found = true;
    return page;
  }
  return straightened(photo, {cv::Point2f{0, 0}, {width, 0}, {width, height}, {0, height}},
                      photo.cols / static_cast<double>(photo.rows));
}

}  // namespace handmap
