#include "core/paper/sheet_watch.h"

#include <algorithm>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/paper/blots.h"
#include "core/paper/sheet_marks.h"

namespace handmap {

namespace {

constexpr double kStill = 0.004;    // of the longer side of an image, from one to the next
constexpr double kSameShape = 0.5;  // intersection over union
constexpr double kUnchanged = 0.9;
constexpr int kComparedWidth = 360;  // pixels, against noise
constexpr double kOtherGrey = 16.0;  // grey levels there
constexpr int kComes = 2;            // images
constexpr int kChanges = 2;
constexpr int kGoes = 3;

cv::Mat smallGrey(const cv::Mat& page) {
  cv::Mat small;
  cv::cvtColor(page, small, cv::COLOR_BGR2GRAY);
  cv::resize(small, small, {kComparedWidth, kComparedWidth * 2 / 3}, 0, 0, cv::INTER_AREA);
  return small;
}

}  // namespace

SheetSight SheetWatch::look(const cv::Mat& image) {
  is_new_ = false;
  const auto seen = sheetOn(image);
  if (!seen || !sheetOf(seen->code)) {
    before_.reset();
    return SheetSight::None;
  }
  if (!isStill(seen->grid, image.size())) return SheetSight::Moving;
  Page page = straightened(image, seen->grid, kSheetWidth_mm / kSheetHeight_mm);
  page.edges_found = true;
  page.sheet = seen->code;
  if (trace_.page.sheet == page.sheet && isSettled() && looksAsBefore(page.image))
    return SheetSight::Seen;
  if (cv::countNonZero(coverOf(page.image)) > 0) return SheetSight::Covered;
  traced_ = smallGrey(page.image);
  is_new_ = true;
  Trace trace = traced(std::move(page));
  settle(std::move(trace.shapes));
  trace_ = std::move(trace);
  trace_.shapes.clear();
  numbers_.clear();
  for (const Watched& watched : watched_) {
    if (watched.seen < kComes) continue;
    trace_.shapes.push_back(watched.shape);
    numbers_.push_back(watched.number);
  }
  return SheetSight::Seen;
}

bool SheetWatch::isSettled() const {
  return std::ranges::all_of(watched_, [](const Watched& watched) {
    return watched.seen >= kComes && watched.missing == 0 && watched.other == 0;
  });
}

/// As the one that was traced.
bool SheetWatch::looksAsBefore(const cv::Mat& page) const {
  return cv::norm(smallGrey(page), traced_, cv::NORM_INF) < kOtherGrey;
}

bool SheetWatch::isStill(const Quad& grid, const cv::Size& image) {
  bool still = before_.has_value();
  for (std::size_t i = 0; still && i < grid.size(); ++i) {
    const cv::Point2f off = grid[i] - (*before_)[i];
    still = std::hypot(off.x, off.y) < kStill * std::max(image.width, image.height);
  }
  before_ = grid;
  return still;
}

void SheetWatch::settle(std::vector<TracedShape> shapes) {
  for (Watched& watched : watched_) {
    const auto same = std::ranges::max_element(shapes, {}, [&](const TracedShape& shape) {
      return intersectionOverUnion(shape.outline, watched.shape.outline);
    });
    const double overlap =
        same == shapes.end() ? 0.0 : intersectionOverUnion(same->outline, watched.shape.outline);
    if (overlap < kSameShape) {
      ++watched.missing;
      continue;
    }
    watched.missing = 0;
    ++watched.seen;
    const bool surer = same->confidence >= kSureOfShape && watched.shape.confidence < kSureOfShape;
    watched.other = overlap < kUnchanged || surer ? watched.other + 1 : 0;
    if (watched.other >= kChanges || watched.seen <= kComes) {
      watched.shape = std::move(*same);
      watched.other = 0;
    }
    shapes.erase(same);
  }
  std::erase_if(watched_, [](const Watched& watched) {
    return watched.missing >= (watched.seen < kComes ? 1 : kGoes);
  });
  for (TracedShape& shape : shapes) watched_.push_back({next_++, std::move(shape), 1, 0, 0});
}

}  // namespace handmap
