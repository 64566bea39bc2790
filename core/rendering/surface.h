// Flat pieces of what is seen. Map frame with z up, metres.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "core/rendering/label.h"
#include "core/simulation/appearance.h"

namespace handmap {

using Vec3 = Eigen::Vector3d;
using Colour = Eigen::Array3f;  ///< red, green, blue; linear

inline Colour colourOf(const Reflectance& c) { return {c[0], c[1], c[2]}; }

enum class Material : std::uint8_t {
  Plain,
  Facade,
  Roof,
  Bark,
  Foliage,
  CarSide,
  CarEnd,
  CarCabin,
  Cloth,
  Sign
};

/// A convex piece of a plane with its own texture coordinates: metres from `origin` along two unit
/// vectors.
struct Surface {
  static constexpr std::size_t kMostCorners = 6;

  std::array<Vec3, kMostCorners> corners;
  std::size_t count = 0;
  Vec3 origin = Vec3::Zero();
  Vec3 along = Vec3::UnitX();
  Vec3 up = Vec3::UnitZ();
  Vec3 normal = Vec3::UnitZ();  ///< unit, outwards
  Material material = Material::Plain;
  Label label = Label::Void;
  std::uint32_t seed = 0;    ///< of the texture
  std::uint32_t facade = 0;  ///< index into Model::facades, for Material::Facade
  Colour colour = Colour::Zero();
  float length = 0.0F;  ///< of the first edge; of a sign its radius, the origin is its middle
  float height = 0.0F;  ///< of parts of cars; negative for Material::CarEnd at the rear
};

/// The look of one wall: that of its building, and where its windows and its door are.
struct Facade {
  Appearance look;
  float eaves_m = 0.0F;
  bool gable = false;     ///< goes on above the eaves
  float margin_m = 0.0F;  ///< before the first bay
  int bays = 0;
  int door_bay = -1;
};

/// Everything near one place.
struct Model {
  std::vector<Surface> surfaces;
  std::vector<Facade> facades;
};

/// A surface around the corners (given around its outward normal), with texture axes: along the
/// first edge, and up across it.
inline Surface surfaceOf(const std::vector<Vec3>& corners, Material material, Label label,
                         const Colour& colour, std::uint32_t seed) {
  Surface surface;
  surface.count = std::min(corners.size(), Surface::kMostCorners);
  for (std::size_t i = 0; i < surface.count; ++i) surface.corners[i] = corners[i];
  surface.origin = corners[0];
  surface.along = (corners[1] - corners[0]).normalized();
  surface.normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  surface.up = surface.normal.cross(surface.along);
  surface.material = material;
  surface.label = label;
  surface.colour = colour;
  surface.seed = seed;
  surface.length = static_cast<float>((corners[1] - corners[0]).norm());
  return surface;
}

}  // namespace handmap
