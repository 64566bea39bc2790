// Which walls of a map were seen: by one observation, and by a whole run.
#pragma once

#include <map>
#include <vector>

#include "core/map/map.h"
#include "core/outlines/structure.h"
#include "core/perception/scan.h"
#include "core/session/on_wall.h"

namespace handmap {

/// The part of a wall on which rays ended.
struct SeenWall {
  std::size_t building;
  std::size_t wall;  ///< from corner `wall` of the footprint to the next
  Segment piece;
  int rays;
};

/// Walls that face the robot and have returns, taken for walls, within `tolerance_m`.
std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m = kOnWall_m);

/// A building that was found, as it is placed now.
struct FoundOutline {
  std::size_t building;
  Polygon outline;
};
/// Those of a corrected map.
std::vector<FoundOutline> foundOutlines(const Map& refined);

/// How many rays of a run ended on each wall: by building, by wall of its footprint.
class WallRays {
 public:
  struct Share {
    int walls = 0;  ///< returns that were taken for walls
    int met = 0;    ///< of those: that ended on walls of such buildings
  };
  /// Of one observation, of buildings that were found so far.
  Share add(const std::vector<FoundOutline>& found, const Pose2& robot, const Scan& scan);
  /// Of all that was seen. `onto_map`: from the frame of `placed` to that of the map.
  static WallRays of(const Map& refined, const PlacedRays& placed, const Pose2& onto_map);

  /// What is stated as seen of buildings that were, and no ray ended on, is so no longer, and no
  /// surer than the drawing says its sizes are: what is known of it was reckoned from other walls.
  void state(const Map& drawing, Map& refined) const;

 private:
  int at(std::size_t building, std::size_t wall) const;

  std::map<std::size_t, std::vector<int>> rays_;
};

}  // namespace handmap
