// The way a robot takes: straight legs with rounded corners. Metres, map frame.
#pragma once

#include <optional>
#include <vector>

#include "core/map/map.h"

namespace handmap {

class Route {
 public:
  /// The points are not all the same.
  explicit Route(const std::vector<Vec2>& points);

  double length() const { return ends_.back(); }
  /// The robot after `s` metres of the legs; a rounded corner is cut by less than kCut.
  static constexpr double kCut = 2.5;
  Pose2 poseAt(double s) const;

  struct Projection {
    double s;       ///< along the legs
    double offset;  ///< of the point from them, positive to the left
  };
  Projection project(const Vec2& point) const;
  /// Least distance between the legs and the polygon, 0 where they meet.
  double distanceTo(const Polygon& polygon) const;

 private:
  std::size_t legAt(double s) const;
  Vec2 pointAt(double s) const;

  std::vector<Segment> legs_;
  std::vector<double> ends_;  ///< s at the end of each leg
};

/// The points of a route that comes back to its first one, driven so often; what follows the last
/// coming back is driven once, at the end. nullopt where it does not come back.
std::optional<std::vector<Vec2>> roundAgain(const std::vector<Vec2>& points, int rounds);

/// The route of a map, begun at its start. A map with no more than a start is driven straight
/// ahead, past the last building or up to the first in the way. nullopt where there is neither or
/// nowhere to go.
std::optional<Route> routeOf(const Map& map);
std::vector<Vec2> routePoints(const Map& map);  ///< the same, its corners

}  // namespace handmap
