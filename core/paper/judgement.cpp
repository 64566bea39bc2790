#include "core/paper/judgement.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace handmap {

namespace {

constexpr double kFrame = 0.5;        // of the page: no building fills more
constexpr double kInside = 0.8;       // of a shape: it lies within another
constexpr double kElongated = 8.0;    // length over width: a road
constexpr double kIslandShare = 0.6;  // of the outline that faces the other side of a road
constexpr double kIsland = 0.3;       // what a block between roads is still worth
constexpr double kLoop = 1.0;         // of a tall letter
constexpr double kLetterLike = 0.3;
constexpr double kHidden = 0.65;  // what an outline behind a hand loses
constexpr double kBroken = 0.8;   // what an outline with a gap is worth

double ramp(double value, double none, double full) {
  return std::clamp((value - none) / (full - none), 0.0, 1.0);
}

class Judgement {
 public:
  Judgement(const std::vector<Candidate>& candidates, const Ink& ink, const PageScale& scale)
      : candidates_(candidates), ink_(ink), scale_(scale) {
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(ink.mask, labels, stats, centres, 8);
    lines_ = ink.mask.clone();
    for (int i = 1; i < count; ++i) {  // handwriting faces nothing
      const cv::Rect box(stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                         stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT));
      if (std::max(box.width, box.height) < scale.letter_px) lines_(box).setTo(0, labels(box) == i);
    }
    for (const Candidate& c : candidates) shape_.push_back(shapeOf(c));
    for (std::size_t i = 0; i < candidates.size(); ++i) look(i);
  }

  std::vector<double> all() const {
    std::vector<double> result;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      double confidence = shape_[i];
      if (contains_[i]) confidence = 0.0;
      if (isLetter(candidates_[i].region)) confidence *= kLetterLike;
      if (!enclosed_[i] && confidence > 0.0 && facing(i) > kIslandShare) confidence *= kIsland;
      result.push_back(confidence);
    }
    return result;
  }

 private:
  /// By its form alone.
  double shapeOf(const Candidate& c) const {
    const Region& r = c.region;
    if (r.filled_area > kFrame * static_cast<double>(ink_.mask.total())) return 0.0;
    const double elongation = r.filled_area / (r.thickness * r.thickness);
    std::vector<cv::Point> hull;
    cv::convexHull(r.outline, hull);
    const double solid = r.filled_area / std::max(1.0, cv::contourArea(hull));
    const double size = ramp(r.thickness, 0.7 * scale_.least_px, 1.3 * scale_.least_px);
    const double seen = 1.0 - kHidden * ramp(c.covered, 0.01, 0.05);
    return seen * (c.inked < 1.0 ? kBroken * c.inked : 1.0) * ramp(solid, 0.4, 0.75) *
           (1.0 - 0.7 * ramp(elongation, 0.6 * kElongated, kElongated)) * (0.4 + 0.6 * size);
  }

  void look(std::size_t i) {
    const Region& own = candidates_[i].region;
    bool contains = false;
    bool enclosed = false;
    for (std::size_t j = 0; j < candidates_.size(); ++j) {
      if (j == i) continue;
      const Region& other = candidates_[j].region;
      if (other.filled_area < own.filled_area) {
        contains =
            contains || (shape_[j] > 0.4 && !isLetter(other) && shareWithin(other, own) > kInside);
      } else {
        enclosed = enclosed || (candidates_[j].inked == 1.0 && shareWithin(own, other) > kInside);
      }
    }
    contains_.push_back(contains);
    enclosed_.push_back(enclosed);
  }

  /// A loop of the size of the signs beside it.
  bool isLetter(const Region& loop) const {
    const cv::Rect tight = cv::boundingRect(loop.outline);
    if (std::max(tight.width, tight.height) > kLoop * scale_.sign_px) return false;
    const int beside = static_cast<int>(scale_.sign_px);
    const cv::Rect wide = cv::Rect(tight.x - beside, tight.y - beside, tight.width + 2 * beside,
                                   tight.height + 2 * beside) &
                          cv::Rect({0, 0}, ink_.mask.size());
    cv::Mat signs = ink_.mask(wide) & ~lines_(wide);
    signs(tight - wide.tl()).setTo(0);
    return cv::countNonZero(signs) > scale_.stroke_px * scale_.sign_px;
  }

  /// The ink that may be the other side of a road, as this shape sees it: not that of plain shapes
  /// that are no larger than it.
  cv::Mat roadsAround(std::size_t i) const {
    cv::Mat roads = lines_.clone();
    const int width = 2 * static_cast<int>(std::ceil(1.5 * scale_.stroke_px)) + 1;
    for (std::size_t j = 0; j < candidates_.size(); ++j) {
      const Region& other = candidates_[j].region;
      const bool plain = j == i || (!contains_[j] && shape_[j] > 0.3 &&
                                    other.filled_area < 2.0 * candidates_[i].region.filled_area);
      if (!plain) continue;
      const std::vector<std::vector<cv::Point>> one = {other.outline};
      cv::drawContours(roads, one, 0, 0, width);
    }
    return roads;
  }

  /// The share of the outline from which a line lies ahead within the width of a road.
  double facing(std::size_t i) const {
    const Region& region = candidates_[i].region;
    const cv::Mat roads = roadsAround(i);
    const auto& outline = region.outline;
    const std::size_t step = std::max<std::size_t>(1, outline.size() / 200);
    const std::size_t span =
        std::max<std::size_t>(2, static_cast<std::size_t>(2 * scale_.stroke_px));
    std::size_t samples = 0;
    std::size_t hits = 0;
    for (std::size_t k = 0; k < outline.size(); k += step) {
      const cv::Point2d before = outline[(k + outline.size() - span) % outline.size()];
      const cv::Point2d after = outline[(k + span) % outline.size()];
      cv::Point2d out((after - before).y, -(after - before).x);
      const double length = cv::norm(out);
      if (length < 1e-9) continue;
      out *= 1.0 / length;
      if (isIn(region, cv::Point2d(outline[k]) + out * (2.0 * scale_.stroke_px))) out *= -1.0;
      ++samples;
      hits += meets(roads, outline[k], out);
    }
    return samples == 0 ? 0.0 : static_cast<double>(hits) / static_cast<double>(samples);
  }

  static bool isIn(const Region& region, const cv::Point2d& at) {
    const cv::Point p = cv::Point(at) - region.box.tl();
    return cv::Rect({0, 0}, region.filled.size()).contains(p) &&
           region.filled.at<std::uint8_t>(p) != 0;
  }

  bool meets(const cv::Mat& roads, const cv::Point2d& from, const cv::Point2d& out) const {
    const cv::Rect page({0, 0}, roads.size());
    for (double d = scale_.least_px; d < scale_.road_px; d += 1.0) {
      const cv::Point p(from + out * d);
      if (!page.contains(p)) return false;
      if (roads.at<std::uint8_t>(p) != 0) return true;
    }
    return false;
  }

  const std::vector<Candidate>& candidates_;
  const Ink& ink_;
  const PageScale& scale_;
  cv::Mat lines_;  ///< the ink without handwriting
  std::vector<double> shape_;
  std::vector<bool> contains_;
  std::vector<bool> enclosed_;
};

}  // namespace

std::vector<double> confidences(const std::vector<Candidate>& candidates, const Ink& ink,
                                const PageScale& scale) {
  return Judgement(candidates, ink, scale).all();
}

}  // namespace handmap
