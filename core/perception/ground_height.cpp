#include "core/perception/ground_height.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

namespace handmap {
namespace {

constexpr float kGroundCell_m = 2.0F;  ///< has a few returns of the ground at 30 m still
constexpr float kMaxSlope = 0.15F;     ///< of streets; the steepest that are built are near it
constexpr float kUnknown = std::numeric_limits<float>::infinity();
constexpr std::size_t kLowest = 3;  ///< the third lowest point of a cell: strays lie below ground

}  // namespace

GroundHeight::GroundHeight(const std::vector<RangePoint>& points, float range_m)
    : cells_(range_m, kGroundCell_m), height_(lowHeights(points)) {
  const int centre = cells_.columnOf(0.0F);
  const int side = cells_.side();
  const auto inwards = [centre](int i) { return i + (i < centre) - (i > centre); };
  const auto follow = [&](int column, int row) {
    if (column < 0 || row < 0 || column >= side || row >= side) return;
    const float inner = height_[cells_.index(inwards(column), inwards(row))];
    float& height = height_[cells_.index(column, row)];
    constexpr float kStep = kMaxSlope * kGroundCell_m;
    height = height == kUnknown ? inner : std::clamp(height, inner - kStep, inner + kStep);
  };
  height_[cells_.index(centre, centre)] = 0.0F;
  for (int ring = 1; ring <= side - centre; ++ring) {
    for (int i = -ring; i <= ring; ++i) {
      follow(centre + i, centre - ring);
      follow(centre + i, centre + ring);
    }
    for (int i = 1 - ring; i < ring; ++i) {
      follow(centre - ring, centre + i);
      follow(centre + ring, centre + i);
    }
  }
}

std::vector<float> GroundHeight::lowHeights(const std::vector<RangePoint>& points) const {
  std::array<float, kLowest> unknown{};
  unknown.fill(kUnknown);
  std::vector<std::array<float, kLowest>> lowest(cells_.count(), unknown);
  for (const RangePoint& p : points) {
    auto& heights = lowest[cells_.of(p.x, p.y)];
    if (p.z >= heights.back()) continue;
    heights.back() = p.z;
    std::sort(heights.begin(), heights.end());
  }
  std::vector<float> low(lowest.size());
  std::transform(lowest.begin(), lowest.end(), low.begin(),
                 [](const auto& heights) { return heights.back(); });
  return low;
}

}  // namespace handmap
