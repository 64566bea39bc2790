// The layers of a drawing: how all objects of a kind are shown and edited. A run does not look at
// it.
#pragma once

#include <array>
#include <cstddef>

namespace handmap {

enum class DrawingLayer { Buildings, Landmarks, Start, Route, Count };

struct LayerState {
  bool hidden = false;   ///< not drawn, not met by the pointer
  bool locked = false;   ///< not met by the pointer
  double opacity = 1.0;  ///< 0 … 1
  bool operator==(const LayerState&) const = default;
};

using LayerStates = std::array<LayerState, static_cast<std::size_t>(DrawingLayer::Count)>;

inline const LayerState& stateOf(const LayerStates& states, DrawingLayer layer) {
  return states[static_cast<std::size_t>(layer)];
}

}  // namespace handmap
