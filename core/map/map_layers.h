// The layers of a drawing: how all objects of a kind are shown and edited. Kept in the file as a
// member of our own, "handmap:layers"; a run does not look at it.
#pragma once

#include <array>

#include "core/map/map.h"

namespace handmap {

enum class DrawingLayer { Buildings, Landmarks, Start, Route, Count };

struct LayerState {
  bool hidden = false;   ///< not drawn, not met by the pointer
  bool locked = false;   ///< not met by the pointer
  double opacity = 1.0;  ///< 0 … 1
  bool operator==(const LayerState&) const = default;
};

using LayerStates = std::array<LayerState, static_cast<std::size_t>(DrawingLayer::Count)>;

/// What the map says; a damaged member counts as absent.
LayerStates layersOf(const Map& map);
/// `members` are the unknown members of a map.
void setLayers(UnknownMembers& members, const LayerStates& states);

inline const LayerState& stateOf(const LayerStates& states, DrawingLayer layer) {
  return states[static_cast<std::size_t>(layer)];
}

}  // namespace handmap
