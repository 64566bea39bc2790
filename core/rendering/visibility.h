// Which surface is seen where: a depth buffer over flat surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "core/rendering/view_camera.h"

namespace handmap {

/// `scale`² samples a pixel, row by row. The ground z = 0 lies everywhere below the horizon.
struct Visibility {
  static constexpr std::int32_t kSky = -1;
  static constexpr std::int32_t kGround = -2;

  int scale = 1;
  int columns = 0;
  int rows = 0;
  std::vector<std::int32_t> seen;    ///< index of a surface, kSky or kGround
  std::vector<float> inverse_depth;  ///< 1/m along the optical axis, 0 for the sky

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// Where a sample lies, in pixels.
  double pixelOf(int sample) const { return (sample + 0.5) / scale - 0.5; }
};

/// Inverse depth is affine over the image on every plane, so depth is exact at each sample.
Visibility visibilityOf(const std::vector<Surface>& surfaces, const ViewCamera& camera, int scale);

/// The inverse depth of a plane through `point` as a function of the pixel: at_u u + at_v v + base.
struct InverseDepth {
  InverseDepth(const Vec3& point, const Vec3& normal, const ViewCamera& camera);
  double at(double u, double v) const { return at_u * u + at_v * v + base; }
  double at_u;
  double at_v;
  double base;
};

}  // namespace handmap
