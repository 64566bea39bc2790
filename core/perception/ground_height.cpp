#include "core/perception/ground_height.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

GroundHeight::GroundHeight(const std::vector<RangePoint>& points, float range_m)
    : cells_(range_m, kGroundCell_m), height_(lowHeights(points)) {
  const int centre = cells_.columnOf(0.0F);
  const int side = cells_.side();
  const auto inwards = [centre](int i) { return i + (i < centre) - (i > centre); };
  const float step = kMaxSlope * kGroundCell_m;
  const auto follow = [&](int column, int row) {
    if (column < 0 || row < 0 || column >= side || row >= side) return;
    const float inner = height_[cells_.index(inwards(column), inwards(row))];
    float& height = height_[cells_.index(column, row)];
    height = height == kUnknownHeight_m ? inner : std::clamp(height, inner - step, inner + step);
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
  std::array<float, kLeastPoints> unknown{};
  unknown.fill(kUnknownHeight_m);
  std::vector<std::array<float, kLeastPoints>> lowest(cells_.count(), unknown);
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
