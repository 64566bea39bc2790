// World files: six numbers beside a picture that say where it lies.
#pragma once

#include <string>
#include <string_view>

#include "core/geometry/pose2.h"

namespace handmap {

struct WorldFile {
  Eigen::Matrix2d per_pixel;  ///< units of the place per pixel right (first column) and down
  Vec2 first;                 ///< place of the middle of the top left pixel

  /// `pixel` counts from the top left corner of the picture.
  Vec2 placeOf(const Vec2& pixel) const { return first + per_pixel * (pixel - Vec2(0.5, 0.5)); }
};

/// Throws BadInput; `source` names the text in messages.
WorldFile parseWorldFile(std::string_view text, const std::string& source);

}  // namespace handmap
