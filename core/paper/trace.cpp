#include "core/paper/trace.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

#include "core/base/phrase.h"
#include "core/paper/blots.h"
#include "core/paper/hatching.h"
#include "core/paper/judgement.h"
#include "core/recording/image_file.h"
#include "core/sketching/stroke.h"
#include "core/sketching/stroke_recognition.h"

namespace handmap {

namespace {

constexpr double kWorthShowing = 0.2;
constexpr double kOverlap = 0.3;  // of the smaller: two shapes are one ink read twice
constexpr double kLeastSide_px = 16.0;
constexpr double kDark = 40.0;   // mean grey level
constexpr double kSharp = 12.0;  // grey levels over two pixels, of the sharpest 0.02 %
constexpr double kPrintedContrast = kDarkestPrint + 0.06;  // and what the camera adds

/// Without lesser readings of the same ink.
std::vector<std::size_t> chosen(const std::vector<Candidate>& candidates,
                                const std::vector<double>& confidence) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (confidence[i] >= kWorthShowing) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (confidence[a] != confidence[b]) return confidence[a] > confidence[b];
    return candidates[a].region.filled_area > candidates[b].region.filled_area;
  });
  std::vector<std::size_t> taken;
  for (const std::size_t i : order) {
    const Region& own = candidates[i].region;
    const bool other_reading = std::ranges::any_of(taken, [&](std::size_t j) {
      const Region& other = candidates[j].region;
      return shareWithin(own, other) > kOverlap || shareWithin(other, own) > kOverlap;
    });
    if (!other_reading) taken.push_back(i);
  }
  return taken;
}

std::optional<cv::Rect> writingIn(const Region& region, const cv::Mat& ink,
                                  const PageScale& scale) {
  const int wall = 2 * static_cast<int>(1.5 * scale.stroke_px) + 1;
  cv::Mat inner;
  cv::erode(region.filled, inner, cv::Mat::ones(wall, wall, CV_8U), {-1, -1}, 1,
            cv::BORDER_CONSTANT, 0);
  inner &= ink(region.box);
  std::vector<cv::Point> points;
  cv::findNonZero(inner, points);
  if (static_cast<double>(points.size()) < 8.0 * scale.stroke_px * scale.stroke_px)
    return std::nullopt;
  return cv::boundingRect(points) + region.box.tl();
}

Polygon upwards(const std::vector<cv::Point>& outline, int rows) {
  Polygon points;
  for (const cv::Point& p : outline) points.push_back({p.x + 0.5, rows - (p.y + 0.5)});
  return points;
}

/// `ink`: without the hatching of what is `drawn`.
TracedShape shapeOf(const Region& region, double confidence, const cv::Mat& drawn, const Ink& ink,
                    const PageScale& scale) {
  TracedShape shape;
  const Polygon stroke = upwards(region.outline, ink.mask.rows);
  const std::vector<ShapeGuess> guesses = recognizedShapes(stroke, scale.stroke_px / 2.0);
  shape.outline =
      guesses.empty() ? strokeOutline(stroke, scale.stroke_px) : guesses.front().outline;
  if (!guesses.empty() && guesses.front().kind == StrokeShape::Rectangular)
    shape.rectangle = guesses.front().rectangle;
  shape.misfit = guesses.empty() ? 1.0 : guesses.front().misfit / diagonalOf(stroke);
  shape.confidence = confidence;
  shape.box = region.box;
  cv::Mat own;
  const int width = 2 * static_cast<int>(scale.stroke_px) + 1;
  cv::dilate(region.filled, own, cv::Mat::ones(width, width, CV_8U));
  shape.ink = drawn(region.box) & own;
  shape.writing = writingIn(region, ink.mask, scale);
  return shape;
}

/// So small, or so narrow, that nothing could be drawn on it.
bool isHardlyAPixel(const cv::Mat& photo) {
  const int longer = std::max(photo.cols, photo.rows);
  const double scale = std::min(1.0, kPhotoSide_px / static_cast<double>(std::max(1, longer)));
  return scale * std::min(photo.cols, photo.rows) < kLeastSide_px;
}

cv::Mat reduced(const cv::Mat& photo) {
  const double scale = kPhotoSide_px / static_cast<double>(std::max(photo.cols, photo.rows));
  if (scale >= 1.0) return photo;
  cv::Mat small;
  cv::resize(photo, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

}  // namespace

Trace traced(Page page) {
  Trace trace;
  trace.page = std::move(page);
  trace.ink = separatedInk(trace.page.image, trace.page.sheet ? kPrintedContrast : kLeastContrast);
  if (!trace.ink.any) return trace;
  Ink ink = trace.ink;
  ink.mask = withoutHatching(ink);
  const PageScale scale(ink);
  const cv::Mat cover = trace.page.sheet ? coverOf(trace.page.image) : cv::Mat();
  trace.covered = !cover.empty() && cv::countNonZero(cover) > 0;
  const std::vector<Candidate> candidates = candidatesOf(ink, scale, cover);
  const std::vector<double> confidence = confidences(candidates, ink, scale);
  for (const std::size_t i : chosen(candidates, confidence)) {
    TracedShape shape = shapeOf(candidates[i].region, confidence[i], trace.ink.mask, ink, scale);
    if (shape.outline.size() >= 3) trace.shapes.push_back(std::move(shape));
  }
  std::ranges::stable_sort(trace.shapes, {}, [](const TracedShape& s) { return s.box.x; });
  return trace;
}

Trace traced(const cv::Mat& photo) {
  if (isHardlyAPixel(photo)) return {};
  const cv::Mat small = reduced(photo);
  Page page = pageOf(small);
  const double scale = small.cols / static_cast<double>(photo.cols);
  page.from_photo = page.from_photo * cv::Matx33d::diag({scale, scale, 1.0});
  return traced(std::move(page));
}

std::string troubleWith(const cv::Mat& photo) {
  if (isHardlyAPixel(photo)) return phrase("the photo has hardly a pixel");
  const cv::Mat grey = greyImage(reduced(photo));
  if (cv::mean(grey)[0] < kDark) return phrase("the photo is dark");
  std::vector<double> steps;
  for (int y = 0; y < grey.rows; y += 2) {
    const auto* row = grey.ptr<std::uint8_t>(y);
    for (int x = 0; x + 2 < grey.cols; ++x) steps.push_back(std::abs(row[x + 2] - row[x]));
  }
  const auto sharpest =
      steps.begin() + static_cast<std::ptrdiff_t>(0.9998 * static_cast<double>(steps.size()));
  std::ranges::nth_element(steps, sharpest);
  return *sharpest < kSharp ? phrase("the photo is blurred, or there is no ink on it")
                            : std::string();
}

std::vector<cv::Point2d> onPhoto(const Polygon& outline, const Page& page) {
  std::vector<cv::Point2d> points;
  for (const Vec2& p : outline) points.emplace_back(p.x(), page.image.rows - p.y());
  if (!points.empty()) cv::perspectiveTransform(points, points, page.from_photo.inv());
  return points;
}

}  // namespace handmap
