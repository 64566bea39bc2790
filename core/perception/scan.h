// What one observation says along every direction of the plane: walls, free space, never seen.
#pragma once

#include <vector>

#include "core/perception/wall_points.h"
#include "core/recording/observation.h"

namespace handmap {

/// One direction that was looked at. The robot looked through everything nearer than `range`.
struct Ray {
  float bearing = 0.0F;  ///< robot frame, radians in (-π, π]
  float range = 0.0F;    ///< metres: of the return; how far was looked through where none came back
  float sigma = 0.0F;    ///< range noise of the return, one σ, metres
  float wall = 0.0F;     ///< 0 … 1: how surely the return is a wall of a building
  bool returned = false;  ///< false: nothing came back along this direction
};

/// Whether what came back is rather a wall of a building than anything else.
inline bool showsWall(const Ray& ray) { return ray.returned && ray.wall >= 0.5F; }

/// At most one ray a direction, sorted by bearing. Directions without a ray were not looked at.
struct Scan {
  std::vector<Ray> rays;
  /// What all ranges may be off together: bias · range², one σ of it. Of stereo, whose disparities
  /// may all be off by a part of a pixel.
  double bias_sigma_per_m = 0.0;
  /// The sensor gives one return a direction, so that nothing back from one says that nothing is
  /// there.
  bool ray_by_ray = false;
  /// Bearings along which something came back for the first time of the run, where the sensor is
  /// of that kind: it had looked there all the while, and nothing was there.
  std::vector<float> first_looked_at;
};

/// What its rays met that show walls, as a planar scanner has them.
std::vector<RangePoint> likelyWalls(const Scan& scan);

/// A scanner looks along one direction after the other, in steps of one width; where the first one
/// is may differ from scan to scan. Corners that a camera follows lie where they lie, and that
/// there is none in a direction says nothing.
class Sweeps {
 public:
  /// Whether all until now, and the one with these points, were a scanner's.
  bool areRegular(const std::vector<RangePoint>& points);
  /// The narrowest that was usual in a scan until now, radians; at least the width of a direction.
  double step() const;

 private:
  double narrowest_ = 0.0;  ///< 0: not known yet
  double steps_ = 0.0;
  double regular_ = 0.0;  ///< no wider than most
};

/// Scans from range points. Remembers which directions ever returned anything: elsewhere (the
/// blind side of a 180° laser) silence does not mean that nothing is there.
class ScanBuilder {
 public:
  explicit ScanBuilder(double range_limit_m);

  /// Points of one observation, and what RangeWalls says of them. One with one return a direction
  /// is taken ray by ray. A scan with vertical structure gives the nearest wall along each
  /// direction, and free space up to the farthest point of anything where there is no wall. Points
  /// without a return tell nothing: no direction of theirs counts as free.
  Scan operator()(const std::vector<RangePoint>& points, const std::vector<WallPoint>& walls);

 private:
  void addRays(const std::vector<RangePoint>& points, Scan& scan);
  void addSilence();
  void addStanding(const std::vector<RangePoint>& points, const std::vector<WallPoint>& walls);

  double range_limit_m_;
  Sweeps sweeps_;
  std::vector<bool> looked_at_;     ///< by direction
  std::vector<bool> not_measured_;  ///< by direction, of this observation
  std::vector<Ray> nearest_;        ///< by direction; range 0: none
};

}  // namespace handmap
