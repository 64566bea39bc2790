// What surfaces are painted with, besides facades.
#pragma once

#include "core/rendering/facade.h"

namespace handmap {

Colour reflectanceAt(const Surface& surface, const Model& model, const TexturePoint& at);

}  // namespace handmap
