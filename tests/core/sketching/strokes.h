// Strokes as hands draw them: around an outline from anywhere, with wobble, rounded corners, and
// ends that miss each other.
#pragma once

#include <cmath>

#include "core/base/random.h"
#include "core/geometry/polygon.h"

namespace handmap {

struct Hand {
  double wobble = 0.01;    ///< σ of the slow waves, of the diagonal
  double jitter = 0.002;   ///< σ of each point, of the diagonal
  double rounding = 0.02;  ///< of the perimeter, at each corner
  double overlap = 0.0;    ///< of the perimeter: drawn twice when positive, a gap when negative
};

inline Polygon strokeAlong(const Polygon& outline, const Hand& hand, RandomStream& random) {
  constexpr std::size_t kPoints = 240;
  double perimeter = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    perimeter += (outline[(i + 1) % outline.size()] - outline[i]).norm();
  const auto at = [&](double way) {
    way = std::fmod(std::fmod(way, perimeter) + perimeter, perimeter);
    for (std::size_t i = 0;; i = (i + 1) % outline.size()) {
      const Vec2 edge = outline[(i + 1) % outline.size()] - outline[i];
      if (way <= edge.norm()) return Vec2(outline[i] + edge.normalized() * way);
      way -= edge.norm();
    }
  };
  const Bounds bounds = boundsOf(outline);
  const double diagonal = (bounds.high - bounds.low).norm();
  const double begin = random.uniform() * perimeter;
  const bool backwards = random.uniform() < 0.5;
  double phases[3][2];
  double sizes[3][2];
  for (int wave = 0; wave < 3; ++wave) {
    for (int axis = 0; axis < 2; ++axis) {
      phases[wave][axis] = random.uniform(0.0, 2.0 * kPi);
      sizes[wave][axis] = hand.wobble * diagonal * random.normal() / std::sqrt(1.5);
    }
  }
  Polygon stroke;
  for (std::size_t i = 0; i <= kPoints; ++i) {
    const double share = static_cast<double>(i) / kPoints * (1.0 + hand.overlap);
    const double way = begin + (backwards ? -share : share) * perimeter;
    // The mean over a stretch rounds the corners.
    Vec2 point = Vec2::Zero();
    for (int k = -4; k <= 4; ++k) point += at(way + k / 8.0 * hand.rounding * perimeter) / 9.0;
    for (int wave = 0; wave < 3; ++wave)
      for (int axis = 0; axis < 2; ++axis)
        point[axis] +=
            sizes[wave][axis] * std::sin(phases[wave][axis] + (2 + wave) * 2.0 * kPi * share) / 1.5;
    point += hand.jitter * diagonal * Vec2(random.normal(), random.normal());
    stroke.push_back(point);
  }
  return stroke;
}

}  // namespace handmap
