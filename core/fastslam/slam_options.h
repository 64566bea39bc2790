// The parameters of FastSLAM/PSOM, with the published values as defaults.
#pragma once

namespace handmap {

/// Noise of one odometry step, in its own terms (Thrun, Burgard, Fox, "Probabilistic Robotics",
/// 5.4): every part is one σ.
struct MotionNoise {
  double length_per_m = 0.03;     ///< of the way driven, m per m
  double heading_per_m = 0.0025;  ///< rad per m driven
  double heading_per_rad = 0.05;  ///< rad per rad turned
  double min_length_m = 0.002;    ///< a step, so that particles of a standing robot stay apart
  double min_heading_rad = 0.0005;
};

/// The paper says "the ratio of the non-zero to the zero cells" under the visible walls, which is
/// unbounded when every cell is hit. ToAll, the share of non-zero cells, orders walls the same way
/// and is bounded; it is the default.
enum class EffectiveRatio { ToAll, ToZero };

struct SlamOptions {
  int slam_particles = 100;
  int pso_particles = 20;   ///< a building; the paper uses 10 and 20
  int pso_iterations = 10;  ///< at most, a frame
  double inertia = 0.5;     ///< w
  double cognitive = 0.8;   ///< c₁
  double social = 1.0;      ///< c₂
  EffectiveRatio effective_ratio = EffectiveRatio::ToAll;
  double resample_below = 0.5;  ///< effective sample size, as a share of the particles
  bool refine = true;           ///< false: Monte Carlo localization on the fixed map (II-C)
  MotionNoise motion;
};

}  // namespace handmap
