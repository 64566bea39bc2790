#include "core/estimation/buildings/outline_placement.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr double kAlong =
    0.9;  // least cosine between a wall and the side that it may be; choice: 26°
constexpr double kSame = 0.05;        // shares of walls that are one; choice
constexpr double kLeastExtent = 0.2;  // share of the drawn side that a part has at least; choice
constexpr double kMostStretch = 2.5;  // choice: drawings are no worse

/// Where along its axis the outline has walls that face a side of the box.
std::vector<double> levels(const Outline& outline, const Rectangle& drawn, std::size_t side) {
  const Box whole = boxOf(drawn);
  std::vector<double> levels;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& begin = outline[(i + outline.size() - 1) % outline.size()];
    const Vec2& end = outline[i];
    const Vec2 normal = -perpendicular((whole.at(end) - whole.at(begin)).normalized());
    if (normal.dot(whole.sideNormal(side)) < kAlong) continue;
    const double level = ((begin + end) / 2.0)[static_cast<int>(side % 2)];
    const auto is_same = [&](double other) { return std::abs(other - level) < kSame; };
    if (std::none_of(levels.begin(), levels.end(), is_same)) levels.push_back(level);
  }
  return levels;
}

/// Reaches of an axis of the box, to its high side and to its low side.
struct Extent {
  double high;
  double low;
};

std::vector<Extent> extents(const Box& found, const Outline& outline, const Rectangle& drawn,
                            std::size_t axis) {
  const double size = found.reach[axis] + found.reach[axis + 2];
  const double drawn_size = axis == 0 ? drawn.width : drawn.depth;
  std::vector<Extent> extents;
  for (const double high : levels(outline, drawn, axis)) {
    for (const double low : levels(outline, drawn, axis + 2)) {
      if (high - low < kLeastExtent) continue;
      const double whole = size / (high - low);
      if (whole > kMostStretch * drawn_size || whole * kMostStretch < drawn_size) continue;
      extents.push_back(
          {found.reach[axis] + (1.0 - high) * whole, found.reach[axis + 2] + low * whole});
    }
  }
  return extents;
}

}  // namespace

std::shared_ptr<const Outline> outlineOf(const Building& drawn) {
  const auto* polygon = std::get_if<Polygon>(&drawn.shape);
  if (polygon == nullptr || polygon->size() > kMostWalls) return nullptr;
  const Box box = boxOf(drawn.box());
  auto outline = std::make_shared<Outline>();
  for (const Vec2& corner : *polygon) outline->push_back(box.shareAt(corner));
  if (signedArea(*polygon) < 0.0) std::reverse(outline->begin(), outline->end());
  return outline;
}

std::vector<Box> placements(const Box& found, const std::shared_ptr<const Outline>& outline,
                            const Rectangle& drawn) {
  std::vector<Box> boxes;
  for (const Extent& x : extents(found, *outline, drawn, 0)) {
    for (const Extent& y : extents(found, *outline, drawn, 1)) {
      Box box = found;
      box.reach = {x.high, y.high, x.low, y.low};
      box.outline = outline;
      boxes.push_back(std::move(box));
    }
  }
  return boxes;
}

}  // namespace handmap
