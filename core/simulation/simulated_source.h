// A robot that drives through a World and reports range points and odometry.
#pragma once

#include <cstdint>
#include <memory>

#include "core/recording/observation.h"
#include "core/simulation/world.h"

namespace handmap {

struct SimulationOptions {
  double step_m = 5.0;   ///< between observations
  bool standing = true;  ///< it stops for each
  double speed_m_s = 1.0;
  int rays = 720;               ///< around the robot
  double view_rad = 2.0 * kPi;  ///< of these, those around straight ahead are measured
  double range_limit_m = kUsualReach_m;
  double sigma_offset_m = 0.05;      ///< σ(d) = offset + quadratic · d²
  double sigma_quadratic = 0.0021;   ///< 1/m
  double outliers = 0.02;            ///< share of rays with a random range
  double lost = 0.0;                 ///< share of rays that do not return from the range limit
  double unrecognised = 0.15;        ///< share of the wall points with weight 0
  double obstacles_mistaken = 0.1;   ///< share of the points on obstacles with weight 1
  double sensor_height_m = 1.0;      ///< z of every point
  double odometry_length = 0.03;     ///< σ of a step's length, as a share
  double odometry_heading = 0.012;   ///< σ of a step's turn, radians
  double odometry_scale = 1.0;       ///< what it makes of a metre
  double odometry_turn_rad_m = 0.0;  ///< what it turns in a metre straight ahead
  /// So often the route is driven: round again where it comes back to its start, else forward and,
  /// in reverse gear, back by turns.
  int rounds = 1;
};

/// A planar laser that does not know what it sees, on a robot that does not stop: noise and
/// outliers of a SICK LMS 200 on a campus (0.03 m, to 60 m), all weights 1.
SimulationOptions laserOnTheMove(double step_m);

/// Where walls are dark and seen aslant: a share of the returns is missing, growing with the square
/// of the distance (a third at 55 m on a campus).
SimulationOptions losingReturns(SimulationOptions options);

/// The same robot stepping differently: its odometry is as wrong after the same way.
SimulationOptions atStep(SimulationOptions options, double step_m);

/// The first observation is at the start of the map; there the odometry is the identity.
/// Deterministic by seed. Truth is in info().truth. Throws BadInput where the map has no way to
/// drive.
std::unique_ptr<ObservationSource> simulate(const World& world, const SimulationOptions& options,
                                            std::uint64_t seed);

}  // namespace handmap
