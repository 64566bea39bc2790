// What the buildings of a world look like from the street: sizes in metres, colours as reflectance.
#pragma once

#include <array>
#include <cstddef>

#include "core/simulation/world.h"

namespace handmap {

/// Red, green, blue; linear, 0 … 1.
using Reflectance = std::array<float, 3>;

struct Appearance {
  enum class Finish { Plaster, Brick, Panels };
  enum class Roof { Flat, Gable, Hip };

  Finish finish = Finish::Plaster;
  Reflectance wall{};
  Reflectance trim{};     ///< frames and surrounds of windows
  Reflectance shutter{};  ///< also of the door
  Reflectance roof_tile{};
  Roof roof = Roof::Flat;
  double roof_pitch_rad = 0.0;
  int storeys = 2;
  double storey_m = 3.0;
  double plinth_m = 0.4;
  double bay_m = 3.0;  ///< from window to window
  double window_width_m = 1.1;
  double window_height_m = 1.3;
  double sill_m = 0.9;  ///< above the floor
  double trim_m = 0.1;  ///< width of the surround
  bool ribbon = false;  ///< windows in one band, as offices have them
  bool shutters = false;
  double weathering = 0.1;  ///< contrast of stains

  double eaves_m() const { return plinth_m + storeys * storey_m + 0.3; }
};

/// Follows from the seed of the world, the building's place in the map and its size: houses have
/// pitched roofs and few storeys, large buildings more and flat ones.
Appearance appearanceOf(const World& world, std::size_t building);

}  // namespace handmap
