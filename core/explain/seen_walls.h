// Which walls of a map were seen: by one observation, and by a whole run.
#pragma once

#include <map>
#include <vector>

#include "core/explain/on_wall.h"
#include "core/map/map.h"
#include "core/outlines/structure.h"
#include "core/perception/scan.h"

namespace handmap {

/// The part of a wall on which rays ended.
struct SeenWall {
  std::size_t building;
  std::size_t wall;  ///< from corner `wall` of the footprint to the next
  Segment piece;
  int rays;
  int through;  ///< rays that would meet it and ended well behind it
  int before;   ///< and a few metres before it
};

/// Walls that face the robot and have returns, taken for walls, within `tolerance_m`.
std::vector<SeenWall> seenWalls(const Map& map, const Pose2& robot, const Scan& scan,
                                double tolerance_m = explain::kOnWall_m);

struct Returns;

/// A building as it is placed now.
struct PlacedOutline {
  std::size_t building;
  Polygon outline;
  bool found;  ///< something that was seen is taken for it
};
/// Those of a corrected map.
std::vector<PlacedOutline> outlinesOf(const Map& refined);

/// How many rays of a run ended on each wall, and how many went through where it is said to stand:
/// by building, by wall of its footprint.
class WallRays {
 public:
  struct Share {
    int walls = 0;    ///< returns that were taken for walls
    int met = 0;      ///< of those: that ended on walls of buildings that were found
    int on = 0;       ///< on walls of any building of the drawing
    int through = 0;  ///< that went through where one is said to stand
  };
  /// Of one observation.
  Share add(const std::vector<PlacedOutline>& buildings, const Pose2& robot, const Scan& scan);
  /// Of all that was seen. `onto_map`: from the frame of `placed` to that of the map.
  static WallRays of(const Map& refined, const PlacedRays& placed, const Pose2& onto_map);

  /// Whether any ended on a wall of it, or went to where one is said to stand.
  bool cameTo(std::size_t building) const { return counts_.contains(building); }

  /// What is stated as seen of buildings that were, and hardly a ray ended on or more went through,
  /// is so no longer, and no surer than the drawing says its sizes are: what is known of it was
  /// reckoned from other walls.
  void state(const Map& drawing, Map& refined) const;

 private:
  struct Count {
    int on = 0;
    int through = 0;
    int before = 0;
  };
  using Counts = std::map<std::size_t, std::vector<Count>>;
  static Share count(const std::vector<PlacedOutline>& outlines, const Returns& returns,
                     Counts& counts);
  bool wasSeen(std::size_t building, std::size_t wall) const;

  Counts counts_;
};

}  // namespace handmap
