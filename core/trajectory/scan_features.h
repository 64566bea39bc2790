// The returns of one observation, told apart by whether they lie on a straight piece.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/recording/observation.h"
#include "core/trajectory/scan_noise.h"

namespace handmap {

/// A return in the plane, robot frame, metres.
struct ScanPoint {
  Vec2 at = Vec2::Zero();      ///< of a straight piece the foot on its line
  Vec2 normal = Vec2::Zero();  ///< of that piece, towards the sensor; zero: it is on none
  /// Of what it tells of a place, the share that may be chance: noise turns the normal of a piece,
  /// and a single return may be of a wall along the way, which is hit elsewhere from everywhere.
  double chance = 0.0;
  double variance =
      0.0;  ///< m², by the noise of the ranges: of the returns of a piece across, else of itself
  /// Above the robot's ground, of a point that was followed; of others no number.
  float height = std::numeric_limits<float>::quiet_NaN();

  bool straight() const { return !normal.isZero(); }
  bool followed() const { return !std::isnan(height); }
  bool known() const { return straight() || followed(); }
};

/// Of a planar scan: in order of bearing, neighbours along the scan; the more of them the noisier
/// the ranges are.
std::vector<ScanPoint> planarFeatures(const std::vector<RangePoint>& points,
                                      const ScanNoise& noise = {});

/// Of points that stand (their heights are left out), in any order: one for each square of 0.35 m,
/// neighbours in the plane.
std::vector<ScanPoint> standingFeatures(const std::vector<Vec2>& points,
                                        const ScanNoise& noise = {});

/// The same points seen from the outer frame of `pose`.
std::vector<ScanPoint> moved(const std::vector<ScanPoint>& points, const Pose2& pose);

/// One of the points for each square of `cell_m`: straight ones first, then the nearest.
std::vector<ScanPoint> thinned(const std::vector<ScanPoint>& points, double cell_m);

}  // namespace handmap
