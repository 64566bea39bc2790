// Round things made of flat pieces: posts, limbs, heads.
#pragma once

#include <vector>

#include "core/geometry/pose2.h"
#include "core/rendering/surface.h"

namespace handmap {

/// A level ellipse: its middle in the frame of the thing, its half axes along and across.
struct Ring {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double along = 0.0;
  double across = 0.0;
};

/// What lies between rings one above the other, closed at the top. The colour, label, material and
/// seed are those of `look`.
inline void addTube(const Pose2& frame, const std::vector<Ring>& rings, int sides,
                    const Surface& look, Model& model) {
  const auto at = [&](const Ring& ring, int i) -> Vec3 {
    const Vec2 round = unitVector(2.0 * kPi * i / sides);
    const Vec2 flat =
        frame.toOuter({ring.x + ring.along * round.x(), ring.y + ring.across * round.y()});
    return {flat.x(), flat.y(), ring.z};
  };
  const auto put = [&](const std::vector<Vec3>& corners) {
    model.surfaces.push_back(surfaceOf(corners, look.material, look.label, look.colour, look.seed));
  };
  for (std::size_t k = 1; k < rings.size(); ++k) {
    for (int i = 0; i < sides; ++i) {
      put({at(rings[k - 1], i), at(rings[k - 1], i + 1), at(rings[k], i + 1), at(rings[k], i)});
    }
  }
  for (int i = 1; i + 1 < sides; ++i) {
    put({at(rings.back(), 0), at(rings.back(), i), at(rings.back(), i + 1)});
  }
}

}  // namespace handmap
