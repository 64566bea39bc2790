#include "core/paper/hatching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "core/paper/disc.h"
#include "core/paper/paper_pieces.h"

namespace handmap {

namespace {

constexpr double kApart = 0.025;  // of the page's longer side, the widest: 7 mm on A4
constexpr double kParallel = 15.0 * CV_PI / 180.0;
constexpr double kStrip = 2.5;
constexpr double kLeastLine = 2.0;  // strokes wide: of less the direction is not known
constexpr int kLeastLines = 4;
constexpr int kDirections = 36;         // of 5°
constexpr double kMainShare = 0.3;      // of the strongest direction: crossed strokes
constexpr double kLeastStrength = 2.5;  // strokes together, over the root of the area they fill

class Groups {
 public:
  explicit Groups(int count) : of_(static_cast<std::size_t>(count)) {
    std::iota(of_.begin(), of_.end(), 0);
  }
  int of(int i) {
    while (of_[at(i)] != i) i = of_[at(i)] = of_[at(of_[at(i)])];
    return i;
  }
  void join(int a, int b) { of_[at(of(a))] = of(b); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::vector<int> of_;
};

/// How long the borders of a group are by direction.
class Directions {
 public:
  void add(const PieceBorder& border) {
    const int bin = binOf(border.angle_rad);
    for (const int off : {-1, 0, 1}) {
      const int to = (bin + off + kDirections) % kDirections;
      weight_[static_cast<std::size_t>(to)] += border.length_px;
    }
  }
  bool isMain(double angle_rad) const {
    const double most = *std::ranges::max_element(weight_);
    return weight_[static_cast<std::size_t>(binOf(angle_rad))] > kMainShare * most;
  }

 private:
  static int binOf(double angle_rad) {
    return std::clamp(static_cast<int>(angle_rad / CV_PI * kDirections), 0, kDirections - 1);
  }
  std::array<double, kDirections> weight_{};
};

struct Hatching {
  int lines = 0;
  double length_px = 0.0;
  double area = 0.0;
};

}  // namespace

cv::Mat withoutHatching(const Ink& ink) {
  const PaperPieces pieces = paperPieces(ink.mask, ink.stroke_px);
  const double apart_px = kApart * std::max(ink.mask.cols, ink.mask.rows);
  const auto narrow = [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    return !pieces.at_edge[at] && pieces.thickness[at] < apart_px;
  };
  const auto alongside = [&](int i, const PieceBorder& border) {
    const auto at = static_cast<std::size_t>(i);
    return pieces.length[at] < kStrip * pieces.width[at] ||
           angleBetween(pieces.axis_rad[at], border.angle_rad) < kParallel;
  };
  std::vector<PieceBorder> lines;
  Groups touching(pieces.count());
  for (const PieceBorder& border : pieces.borders) {
    if (!narrow(border.a) || !narrow(border.b)) continue;
    if (border.length_px < kLeastLine * ink.stroke_px) continue;
    if (border.bend_px > 0.4 * ink.stroke_px + 0.02 * border.length_px) continue;
    lines.push_back(border);
    touching.join(border.a, border.b);
  }
  std::map<int, Directions> directions;
  for (const PieceBorder& line : lines) directions[touching.of(line.a)].add(line);

  Groups hatched(pieces.count());
  std::vector<const PieceBorder*> joining;
  for (const PieceBorder& line : lines) {
    if (!alongside(line.a, line) || !alongside(line.b, line)) continue;
    if (!directions[touching.of(line.a)].isMain(line.angle_rad)) continue;
    hatched.join(line.a, line.b);
    joining.push_back(&line);
  }
  std::map<int, Hatching> found;
  for (const PieceBorder* line : joining) {
    Hatching& hatching = found[hatched.of(line->a)];
    ++hatching.lines;
    hatching.length_px += line->length_px;
  }
  for (int i = 0; i < pieces.count(); ++i) {
    const auto group = found.find(hatched.of(i));
    if (group != found.end()) group->second.area += pieces.area[static_cast<std::size_t>(i)];
  }
  std::erase_if(found, [](const auto& entry) {
    const Hatching& hatching = entry.second;
    return hatching.lines < kLeastLines ||
           hatching.length_px < kLeastStrength * std::sqrt(hatching.area);
  });

  // Strokes go where one hatching is on both sides of them.
  cv::Mat left = ink.mask.clone();
  const auto groupAt = [&](int y, int x) { return hatched.of(pieces.labels.at<int>(y, x)); };
  const int reach = static_cast<int>(std::ceil(ink.stroke_px)) + 1;
  for (const auto& [group, hatching] : found) {
    cv::Rect box;
    for (int i = 0; i < pieces.count(); ++i)
      if (hatched.of(i) == group) box |= pieces.box[static_cast<std::size_t>(i)];
    cv::Mat own = cv::Mat::zeros(box.height + 4 * reach, box.width + 4 * reach, CV_8U);
    for (int y = box.y; y < box.br().y; ++y)
      for (int x = box.x; x < box.br().x; ++x)
        if (groupAt(y, x) == group && ink.mask.at<std::uint8_t>(y, x) == 0)
          own.at<std::uint8_t>(y - box.y + 2 * reach, x - box.x + 2 * reach) = 255;
    cv::morphologyEx(own, own, cv::MORPH_CLOSE, disc(reach));
    left(box).setTo(0, own(cv::Rect(2 * reach, 2 * reach, box.width, box.height)));
  }
  return left;
}

}  // namespace handmap
