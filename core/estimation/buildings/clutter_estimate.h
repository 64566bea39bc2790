// How many returns come from things in front of walls, estimated around the walls that were found.
#pragma once

#include <span>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/buildings/found_box.h"

namespace handmap {

/// Collected over frames; a little is forgotten with each.
class ClutterEstimate {
 public:
  void add(const Frame& frame, std::span<const FoundBox> boxes, const SensorModel& sensor);
  /// Little where little was seen yet.
  Clutter measured() const;

 private:
  /// Shares of the rays that go to a wall, or past its end, and end early.
  struct Share {
    double blocked = buildings::kFirstBlocked;
    double rays = buildings::kFirstRays;
    void forget();
  };

  void addBefore(const Frame& frame, const Box& box, const SensorModel& sensor);
  void addAtEnds(const Frame& frame, const Box& box, const SensorModel& sensor);

  double looked_m_ = buildings::kFirstLooked_m;  ///< along rays, in front of walls
  double wall_like_ = 0.0;                       ///< returns from there
  double others_ = 0.0;
  Share at_walls_;
  Share beside_;
};

/// Whether evidence weighed with one is no longer worth anything with the other.
bool differMuch(const Clutter& a, const Clutter& b);

}  // namespace handmap
