// Where a picture under the drawing lies: from its pixels to the map and back, and the place, turn
// and scale that agree best with what is known of single pixels. Pixels count right and down from
// the top left corner of the picture; points are metres of the map.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/map/map.h"

namespace handmap {

Vec2 pointOf(const Underlay& underlay, const Vec2& pixel);
Vec2 pixelOf(const Underlay& underlay, const Vec2& point);

struct PointPair {
  Vec2 pixel;
  Vec2 point;
};

struct UnderlayFit {
  Underlay underlay;
  double residual = 0.0;  ///< greatest distance of a pixel from its point, metres
};

/// The similarity (place, turn, one scale; never mirrored) of least squared distances of two or
/// more pairs. nullopt: fewer, all at one place, or a scale or place that no map can hold.
std::optional<UnderlayFit> fitted(const Underlay& underlay, std::span<const PointPair> pairs);

/// Made so large that the two points of the picture that now lie at `a` and `b` are `length_m`
/// apart; `a` stays. nullopt as above.
std::optional<Underlay> scaled(const Underlay& underlay, const Vec2& a, const Vec2& b,
                               double length_m);

/// What the file of a picture tells of where it lies: some pixels and their places, either in
/// degrees (longitude, latitude; WGS 84) or in metres of a plane that nobody knows.
struct PictureGeometry {
  enum class Kind { LongitudeLatitude, Metres };
  Kind kind = Kind::Metres;
  std::vector<PointPair> pairs;
};

struct GroundedUnderlay {
  UnderlayFit fit;
  std::optional<Georeference> georeference;  ///< of the map; absent: it stays as it is
};

/// Lays a picture where its file says. A map that has no georeference is given one so that the
/// middle of the picture comes to `middle`; that too is where it lies without any. nullopt as
/// above: a picture of another country.
std::optional<GroundedUnderlay> grounded(const Underlay& underlay, const PictureGeometry& geometry,
                                         const std::optional<Georeference>& of_map,
                                         const Vec2& middle);

}  // namespace handmap
