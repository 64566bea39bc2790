// Walls with windows and doors, drawn from their measures.
#pragma once

#include "core/rendering/surface.h"

namespace handmap {

/// A place on a surface, metres, and how much of it a pixel covers along and up.
struct TexturePoint {
  float u = 0.0F;
  float v = 0.0F;
  float du = 0.0F;
  float dv = 0.0F;
};

/// Reflectance of a wall; `wall` has Material::Facade.
Colour facadeColour(const Surface& wall, const Facade& facade, const TexturePoint& at);

}  // namespace handmap
