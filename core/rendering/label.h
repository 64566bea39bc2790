// What a pixel shows, numbered as the CamVid benchmark does (Brostow, Fauqueur, Cipolla 2009; the
// eleven classes of Badrinarayanan et al. 2017).
#pragma once

#include <cstdint>

namespace handmap {

enum class Label : std::uint8_t {
  Sky = 0,
  Building = 1,
  Pole = 2,
  Road = 3,
  Pavement = 4,
  Tree = 5,  ///< all that is green: trees, hedges, grass
  Sign = 6,
  Fence = 7,
  Car = 8,
  Pedestrian = 9,
  Bicyclist = 10,
  Void = 11,
};

}  // namespace handmap
