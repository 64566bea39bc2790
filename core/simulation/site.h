// The ground of a world and what stands on it already.
#pragma once

#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {

class Site {
 public:
  static constexpr double kToWall_m = 0.4;    ///< what is put keeps this distance from all else
  static constexpr double kPavement_m = 5.4;  ///< ends so far from the route: hedges and fences

  /// The world has a route, and nothing but the site adds things to it.
  explicit Site(World& world);

  const Route& route() const { return route_; }
  /// Adds the things that stand where nothing stands yet and the robot does not pass; those of one
  /// group may touch each other.
  void put(const std::vector<Thing>& group);
  bool isFree(const Rectangle& footprint) const;
  /// From now on a building stands there.
  void take(const Rectangle& footprint) { footprints_.push_back(footprint.corners()); }

 private:
  World& world_;
  Route route_;
  std::vector<Polygon> footprints_;  ///< of buildings and things
};

}  // namespace handmap
