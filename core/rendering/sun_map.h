// Where the sun shines: a shadow map, looked at along the light.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/rendering/surface.h"

namespace handmap {

/// For every ray of sunlight, named by where it would meet the ground, the height at which it first
/// meets a surface. Covers 80 m around `centre`; beyond, all is sunlit.
class SunMap {
 public:
  /// `to_sun` is a unit vector, up.
  SunMap(const Vec2& centre, const Vec3& to_sun);

  void add(const std::vector<Surface>& surfaces);
  /// 0 … 1: how much of the sun gets to a point of a surface that faces it; on the ground at its
  /// foot the same as on a wall that stands there.
  float sunAt(const Vec3& point, const Vec3& normal) const;

 private:
  void draw(const Surface& surface);
  Vec2 cellOf(const Vec3& point) const;

  Vec3 to_sun_;
  Vec2 per_height_;   ///< metres that sunlight goes aside for each it comes down
  Vec2 low_;          ///< of the square, map frame
  cv::Mat1f height_;  ///< of what shades a cell; 0: nothing does
};

}  // namespace handmap
