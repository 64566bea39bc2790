#include "core/sketching/corners.h"

namespace handmap {

namespace {

std::optional<Polygon> whenSimple(Polygon outline) {
  if (!isSimple(outline) || signedArea(outline) <= 0.0) return std::nullopt;
  return outline;
}

template <typename Distance>
std::optional<std::size_t> nearest(std::size_t count, double reach, Distance distance) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < count; ++i) {
    const double its = distance(i);
    if (its > reach) continue;
    reach = its;
    best = i;
  }
  return best;
}

}  // namespace

std::optional<Polygon> withCornerAt(Polygon outline, std::size_t corner, const Vec2& position) {
  outline[corner] = position;
  return whenSimple(std::move(outline));
}

std::optional<Polygon> withCornerOn(Polygon outline, std::size_t edge, const Vec2& position) {
  outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(edge) + 1, position);
  return whenSimple(std::move(outline));
}

std::optional<Polygon> withoutCorner(Polygon outline, std::size_t corner) {
  outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(corner));
  return whenSimple(std::move(outline));
}

std::optional<std::size_t> cornerNear(const Polygon& outline, const Vec2& point, double reach) {
  return nearest(outline.size(), reach, [&](std::size_t i) { return (outline[i] - point).norm(); });
}

std::optional<std::size_t> edgeNear(const Polygon& outline, const Vec2& point, double reach,
                                    std::size_t edges) {
  return nearest(edges, reach,
                 [&](std::size_t i) { return distanceTo(edgeOf(outline, i), point); });
}

Segment edgeOf(const Polygon& outline, std::size_t edge) {
  return {outline[edge], outline[(edge + 1) % outline.size()]};
}

}  // namespace handmap
