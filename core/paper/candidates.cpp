#include "core/paper/candidates.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <opencv2/imgproc.hpp>

#include "core/paper/blots.h"
#include "core/paper/disc.h"
#include "core/paper/strokes.h"

namespace handmap {

namespace {

// Shares of the longer side of a page. Handwriting is 3 to 6 mm high on A4 (297 mm), a corner is
// missed by up to 4 mm, and both sides of a road are 5 to 12 mm apart.
constexpr double kLeast = 0.012;
constexpr double kGap = 0.015;
constexpr double kLetter = 0.035;
constexpr double kRoad = 0.04;

constexpr std::size_t kMost = 300;         // of a page: a texture has more
constexpr std::size_t kMostPieces = 1500;  // with the holes of its letters
constexpr double kSame = 0.75;             // a piece that covers so much is the whole
constexpr double kLeastInked = 0.85;
constexpr double kLetters = 4.0;  // writing reaches across no more than its height times that
constexpr double kWord = 1.7;     // less thick, and it is the word itself
constexpr double kBeyond = 3.0;   // a drawing's box over that of what it encloses
constexpr double kSolid = 0.8;    // of the convex hull: what is left without its writing

cv::Mat onPage(const Region& region, const cv::Rect& area) {
  cv::Mat mask = cv::Mat::zeros(area.size(), CV_8U);
  const cv::Rect common = region.box & area;
  if (!common.empty()) {
    region.filled(common - region.box.tl()).copyTo(mask(common - area.tl()));
  }
  return mask;
}

/// The ink between two pieces, where it is a wall: one straight stroke from side to side.
class Walls {
 public:
  Walls(const cv::Mat& ink, const Region& whole, double stroke_px)
      : box_(whole.box), ink_(ink(whole.box)), stroke_(stroke_px) {
    cv::distanceTransform(whole.filled, inside_, cv::DIST_L2, 3);
  }

  void look(const Region& a, const Region& b) {
    const cv::Mat reach = disc(stroke_ + 1.0);
    cv::Mat near_a, near_b, between;
    cv::dilate(onPage(a, box_), near_a, reach);
    cv::dilate(onPage(b, box_), near_b, reach);
    cv::bitwise_and(near_a, near_b, between);
    cv::bitwise_and(between, ink_, between);
    std::vector<cv::Point> points;
    cv::findNonZero(between, points);
    if (static_cast<double>(points.size()) < 4.0 * stroke_) return;
    const cv::RotatedRect around = cv::minAreaRect(points);
    const double length = std::max(around.size.width, around.size.height);
    const double width = std::min(around.size.width, around.size.height);
    if (width > 3.0 * stroke_ + 0.08 * length) return;
    if (static_cast<double>(points.size()) < 0.7 * length * stroke_) return;
    const double angle =
        (around.angle + (around.size.width >= around.size.height ? 0.0 : 90.0)) * CV_PI / 180.0;
    const cv::Point2f half(static_cast<float>(std::cos(angle) * length / 2.0),
                           static_cast<float>(std::sin(angle) * length / 2.0));
    found_.push_back({around.center - half, around.center + half});
  }

  /// Those that reach from outside to outside, or to one another.
  cv::Mat mask() const {
    cv::Mat walls = cv::Mat::zeros(ink_.size(), CV_8U);
    const int width = std::max(2, static_cast<int>(std::lround(stroke_)));
    for (const auto& [a, b] : found_) {
      if (ends(a) && ends(b)) cv::line(walls, a, b, 255, width + 2);
    }
    return walls;
  }

 private:
  struct Wall {
    cv::Point2f a, b;
  };

  bool ends(const cv::Point2f& at) const {
    const cv::Point p(std::clamp(static_cast<int>(at.x), 0, inside_.cols - 1),
                      std::clamp(static_cast<int>(at.y), 0, inside_.rows - 1));
    if (inside_.at<float>(p) < 3.0 * stroke_) return true;
    return std::ranges::any_of(found_, [&](const Wall& wall) {
      if (wall.a == at || wall.b == at) return false;
      const cv::Point2f way = wall.b - wall.a;
      const float t = std::clamp((at - wall.a).dot(way) / way.dot(way), 0.0f, 1.0f);
      return cv::norm(at - (wall.a + t * way)) < 3.0 * stroke_;
    });
  }

  cv::Rect box_;
  cv::Mat ink_;
  cv::Mat inside_;
  double stroke_;
  std::vector<Wall> found_;
};

/// All that a connected drawing of strokes encloses, without what thinly sticks out.
std::vector<Region> wholes(const cv::Mat& ink, const PageScale& scale) {
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> nesting;
  cv::findContours(ink, contours, nesting, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<Region> found;
  const cv::Rect page({0, 0}, ink.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (nesting[i][3] >= 0) continue;  // a hole
    const auto& contour = contours[i];
    const cv::Rect tight = cv::boundingRect(contour);
    if (std::min(tight.width, tight.height) < scale.least_px) continue;
    const cv::Rect box =
        cv::Rect(tight.x - 3, tight.y - 3, tight.width + 6, tight.height + 6) & page;
    cv::Mat mask = cv::Mat::zeros(box.size(), CV_8U);
    const std::vector<std::vector<cv::Point>> one = {contour};
    cv::drawContours(mask, one, 0, 255, cv::FILLED, cv::LINE_8, cv::noArray(), 0, -box.tl());
    cv::morphologyEx(mask, mask, cv::MORPH_OPEN, disc(scale.least_px / 2.0));
    // Lines that go on beyond are roads, and the writing is their names.
    const cv::Rect thick = cv::boundingRect(mask);
    if (thick.empty() || kBeyond * thick.area() < tight.area()) continue;
    cv::erode(mask, mask, disc(scale.stroke_px / 2.0));
    found.push_back(regionOf(mask, box, scale.stroke_px));
  }
  return found;
}

/// Buildings that writing cuts into pieces: the whole, divided by its walls alone.
std::vector<Region> undividedByWriting(const cv::Mat& ink, const std::vector<Region>& pieces,
                                       const PageScale& scale) {
  std::vector<Region> found;
  for (const Region& whole : wholes(ink, scale)) {
    Walls walls(ink, whole, scale.stroke_px);
    std::vector<const Region*> own;
    for (const Region& piece : pieces) {
      if (shareWithin(piece, whole) > 0.8) own.push_back(&piece);
    }
    if (own.empty() || own.size() > 40) continue;
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = i + 1; j < own.size(); ++j) {
        if (!(own[i]->box & own[j]->box).empty()) walls.look(*own[i], *own[j]);
      }
    }
    cv::Mat rest = whole.filled & ~walls.mask();
    cv::morphologyEx(rest, rest, cv::MORPH_OPEN, disc(scale.least_px / 3.0));
    cv::Mat labels;
    const int count = cv::connectedComponents(rest, labels, 4);
    const double most_px = kLetters * scale.letter_px;
    const double least_px = std::max(scale.least_px, kWord * scale.sign_px);
    for (int i = 1; i < count; ++i) {
      const cv::Mat mask = labels == i;
      const cv::Rect tight = cv::boundingRect(mask);
      Region cell = regionOf(mask(tight), tight + whole.box.tl(), 1.0);
      if (cell.thickness < least_px || cell.thickness > most_px) continue;
      if (std::max(cell.box.width, cell.box.height) > 2.0 * most_px) continue;
      std::vector<cv::Point> hull;
      cv::convexHull(cell.outline, hull);
      if (cell.filled_area < kSolid * cv::contourArea(hull)) continue;
      const bool known = std::ranges::any_of(own, [&](const Region* piece) {
        return piece->filled_area > kSame * cell.filled_area && shareWithin(*piece, cell) > 0.8;
      });
      if (!known) found.push_back(std::move(cell));
    }
  }
  return found;
}

/// What three of four things as large as handwriting do not exceed: capitals and tall letters.
double usualSign(const cv::Mat& ink, double least_px, double most_px) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(ink, labels, stats, centres, 8);
  std::vector<int> signs;
  for (int i = 1; i < count; ++i) {
    const int size =
        std::max(stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
    if (size > least_px && size < most_px) signs.push_back(size);
  }
  if (signs.empty()) return 0.0;
  const auto tall = signs.begin() + static_cast<std::ptrdiff_t>(signs.size() * 3 / 4);
  std::ranges::nth_element(signs, tall);
  return *tall;
}

/// Of the outline, on the mask.
double shareOn(const cv::Mat& mask, const Region& region) {
  const auto on = std::ranges::count_if(
      region.outline, [&](const cv::Point& p) { return mask.at<std::uint8_t>(p) != 0; });
  return static_cast<double>(on) /
         static_cast<double>(std::max<std::size_t>(1, region.outline.size()));
}

std::vector<Region> largest(std::vector<Region> regions) {
  std::ranges::stable_sort(regions, std::greater(), &Region::filled_area);
  if (regions.size() > kMostPieces) regions.resize(kMostPieces);
  return regions;
}

bool isPartOf(const Region& part, const Region& whole) {
  return part.filled_area < whole.filled_area && shareWithin(part, whole) > kSame;
}

/// A blot at a shape is of its hatching.
bool touches(const Region& blot, const Region& shape, const PageScale& scale) {
  cv::Mat wide = onPage(blot, shape.box);
  cv::dilate(wide, wide, disc(2.0 * scale.stroke_px));
  return cv::countNonZero(wide & shape.filled) > 0;
}

bool isKnown(const Region& region, const std::vector<Candidate>& candidates) {
  return std::ranges::any_of(candidates, [&](const Candidate& c) {
    return shareWithin(region, c.region) > kSame && shareWithin(c.region, region) > kSame;
  });
}

}  // namespace

PageScale::PageScale(const Ink& ink) : stroke_px(ink.stroke_px) {
  const double side = std::max(ink.mask.cols, ink.mask.rows);
  least_px = std::max(kLeast * side, 2.5 * stroke_px);
  gap_px = kGap * side;
  letter_px = kLetter * side;
  road_px = kRoad * side;
  sign_px = usualSign(ink.mask, 3.0 * stroke_px, letter_px);
}

std::vector<Candidate> candidatesOf(const Ink& ink, const PageScale& scale, const cv::Mat& cover) {
  std::vector<Candidate> candidates;
  const double small_px = 2.0 * scale.stroke_px;
  const std::vector<Region> pieces = largest(enclosedRegions(ink.mask, scale.stroke_px, small_px));
  for (const Region& piece : pieces) {
    if (piece.thickness >= scale.least_px) candidates.push_back({piece});
  }
  for (Region& whole : undividedByWriting(ink.mask, pieces, scale)) {
    if (isKnown(whole, candidates)) continue;
    std::erase_if(candidates, [&](const Candidate& c) { return isPartOf(c.region, whole); });
    candidates.push_back({std::move(whole)});
  }
  cv::Mat bridged = ink.mask.clone();
  for (const auto& [from, to] : bridges(thinned(ink.mask), scale.gap_px)) {
    cv::line(bridged, from, to, 255, std::max(2, static_cast<int>(scale.stroke_px)));
  }
  // What the edge of the page cuts off by little.
  const int margin = marginOf(bridged.size());
  cv::rectangle(bridged, {margin, margin}, {bridged.cols - 1 - margin, bridged.rows - 1 - margin},
                255, 3);
  cv::Mat near_ink;
  cv::dilate(ink.mask, near_ink, disc(scale.stroke_px));
  for (Region& region : largest(enclosedRegions(bridged, scale.stroke_px, scale.least_px))) {
    const double inked = shareOn(near_ink, region);
    if (inked < kLeastInked || isKnown(region, candidates)) continue;
    // Within a shape that is closed already only if that is much larger: a block.
    const bool part = std::ranges::any_of(candidates, [&](const Candidate& c) {
      return isPartOf(region, c.region) && c.region.thickness < kLetters * scale.letter_px;
    });
    if (!part) candidates.push_back({std::move(region), inked});
  }
  Blots blots = blotsOf(ink, scale);
  if (!cover.empty()) {
    cv::Mat wide;
    cv::dilate(cover, wide, disc(2.0 * scale.stroke_px));
    blots.foreign |= wide;
  }
  std::erase_if(blots.filled, [&](const Region& filled) {
    return std::ranges::any_of(
        candidates, [&](const Candidate& c) { return touches(filled, c.region, scale); });
  });
  for (Region& filled : blots.filled) candidates.push_back({std::move(filled)});
  for (Candidate& c : candidates) c.covered = shareOn(blots.foreign, c.region);
  std::ranges::stable_sort(candidates, std::greater(),
                           [](const Candidate& c) { return c.region.filled_area; });
  if (candidates.size() > kMost) candidates.resize(kMost);
  return candidates;
}

}  // namespace handmap
