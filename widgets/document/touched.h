// Which parts of a map a step has changed: what shows the map follows only that.
#pragma once

#include <cstddef>
#include <vector>

namespace handmap {

struct Touched {
  std::vector<std::size_t> buildings = {};  ///< places of those that are others; not where listed
  bool listed = false;  ///< buildings came, went or have another id: all count as others
  bool landmarks = false;
  bool start = false;  ///< or how sure it is
  bool route = false;
  bool underlays = false;
  bool layers = false;
  bool rest = false;  ///< name, uncertainty, georeference, model, refinement

  static Touched everything() { return {{}, true, true, true, true, true, true, true}; }

  bool anyBuilding() const { return listed || !buildings.empty(); }
  /// Only the buildings at those places.
  bool onlyPlaces() const {
    return !(listed || landmarks || start || route || underlays || layers || rest);
  }
  Touched& operator|=(const Touched& other) {
    buildings.insert(buildings.end(), other.buildings.begin(), other.buildings.end());
    listed |= other.listed;
    landmarks |= other.landmarks;
    start |= other.start;
    route |= other.route;
    underlays |= other.underlays;
    layers |= other.layers;
    rest |= other.rest;
    return *this;
  }
};

}  // namespace handmap
