#include "core/simulation/drive.h"

#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/random.h"
#include "core/simulation/route.h"

namespace handmap {

namespace {

constexpr std::uint32_t kOdometry = 5;
constexpr double kMaxSteps = 1e6;

/// Where the robot is after so many metres.
class Way {
 public:
  Way(const Map& map, int rounds) : once_(routeOf(map)), rounds_(rounds) {
    if (!once_ || rounds == 1) return;
    const auto again = roundAgain(routePoints(map), rounds);
    if (!again) return;
    once_ = Route(*again);
    rounds_ = 1;
  }

  explicit operator bool() const { return once_.has_value(); }
  double length() const { return rounds_ * once_->length(); }
  Pose2 poseAt(double s) const {
    if (rounds_ == 1) return once_->poseAt(s);
    return once_->poseAt(std::abs(std::remainder(s, 2.0 * once_->length())));
  }

 private:
  std::optional<Route> once_;
  int rounds_;
};

/// What the odometry makes of a step.
Pose2 told(const Pose2& step, const SimulationOptions& options, RandomStream& random) {
  const double stretch = options.odometry_scale * random.normal(1.0, options.odometry_length);
  const double turn = options.odometry_turn_rad_m * step.position().norm() +
                      random.normal(0.0, options.odometry_heading);
  return {stretch * step.x, stretch * step.y, step.heading + turn};
}

}  // namespace

Drive driveThrough(const Map& map, const SimulationOptions& options, std::uint64_t seed) {
  const Way way(map, options.rounds);
  if (!way) {
    throwBadInput(phrase("route"), "", phrase("no way to drive"), phrase("a route or a start"));
  }
  if (!(options.step_m > 0.0 && way.length() / options.step_m < kMaxSteps)) {
    throwBadInput(phrase("simulation"), phrase("step"), fmt::format("{} m", options.step_m),
                  phrase("a positive one, less than {:g} on the route", kMaxSteps));
  }
  RandomStream random(seed, 0, 0, kOdometry);
  const int steps = static_cast<int>(way.length() / options.step_m + 1e-9);
  Drive drive;
  Pose2 odometry;
  for (int i = 0; i <= steps; ++i) {
    Pose2 truth = way.poseAt(i * options.step_m);
    if (i == 0 && map.start) truth = *map.start;
    if (i > 0) odometry = odometry * told(between(drive.truth.back().pose, truth), options, random);
    const double time_s = i * options.step_m / options.speed_m_s;
    drive.truth.push_back({time_s, truth});
    drive.odometry.push_back({time_s, odometry});
  }
  return drive;
}

SourceInfo infoOf(const World& world, const SimulationOptions& options, std::uint64_t seed) {
  Drive drive = driveThrough(world.map, options, seed);
  SourceInfo info;
  info.name = world.map.name;
  info.range_limit_m = options.range_limit_m;
  info.observations = static_cast<int>(drive.truth.size());
  info.truth = std::move(drive.truth);
  info.odometry = std::move(drive.odometry);
  return info;
}

Observation observationAt(std::size_t pose, const SourceInfo& info) {
  Observation observation;
  observation.frame = static_cast<int>(pose);
  observation.time_s = info.truth[pose].time_s;
  observation.odometry = info.odometry[pose].pose;
  return observation;
}

SimulationOptions atStep(SimulationOptions options, double step_m) {
  const double steps = options.step_m / step_m;
  options.step_m = step_m;
  options.odometry_length *= std::sqrt(steps);
  options.odometry_heading /= std::sqrt(steps);
  return options;
}

}  // namespace handmap
