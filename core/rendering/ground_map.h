// The ground near one place: road, pavement, gardens, and the shadows on it.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/rendering/surface.h"

namespace handmap {

/// A road follows the route: 4 m to the kerb on either side, then 1.4 m of pavement.
class GroundMap {
 public:
  GroundMap(const std::vector<Vec2>& route, const Vec2& centre, std::uint64_t seed);

  /// What stands there, up to `height_m`, keeps the sun off. `to_sun` is a unit vector.
  void addShadow(const Polygon& footprint, double height_m, const Vec3& to_sun);
  /// The same for a ball above the ground.
  void addShadow(const Vec2& centre, double radius_m, double height_m, const Vec3& to_sun);
  /// Call when all are added.
  void softenShadows();

  Label labelAt(float x, float y) const;
  /// Reflectance where a pixel covers `pixel` metres.
  Colour colourAt(float x, float y, float pixel) const;
  /// 0 … 1: how much of the sun gets there.
  float sunAt(float x, float y) const;

 private:
  cv::Point2f cellOf(const Vec2& place) const;
  void fillConvex(const std::vector<Vec2>& corners);
  float sampled(const cv::Mat1f& map, float x, float y, float outside) const;
  Colour roadAt(float x, float y, float pixel) const;
  Colour gardenAt(float x, float y, float pixel) const;

  Vec2 low_;  ///< of the square, map frame
  std::uint32_t seed_;
  cv::Mat1f road_;  ///< metres from the middle of the road
  cv::Mat1b shadow_;
  cv::Mat1f sun_;
};

}  // namespace handmap
