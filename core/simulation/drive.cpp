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

}  // namespace

Drive driveThrough(const Map& map, const SimulationOptions& options, std::uint64_t seed) {
  const std::optional<Route> route = routeOf(map);
  if (!route) {
    throwBadInput(phrase("route"), "", phrase("no way to drive"), phrase("a route or a start"));
  }
  if (!(options.step_m > 0.0 && route->length() / options.step_m < kMaxSteps)) {
    throwBadInput(phrase("simulation"), phrase("step"), fmt::format("{} m", options.step_m),
                  phrase("a positive one, less than {:g} on the route", kMaxSteps));
  }
  RandomStream random(seed, 0, 0, kOdometry);
  const int steps = static_cast<int>(route->length() / options.step_m + 1e-9);
  Drive drive;
  Pose2 odometry;
  for (int i = 0; i <= steps; ++i) {
    Pose2 truth = route->poseAt(i * options.step_m);
    if (i == 0 && map.start) truth = *map.start;
    if (i > 0) {
      Pose2 step = between(drive.truth.back().pose, truth);
      const double stretch = random.normal(1.0, options.odometry_length);
      step = {stretch * step.x, stretch * step.y,
              step.heading + random.normal(0.0, options.odometry_heading)};
      odometry = odometry * step;
    }
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

SimulationOptions atStep(SimulationOptions options, double step_m) {
  const double steps = options.step_m / step_m;
  options.step_m = step_m;
  options.odometry_length *= std::sqrt(steps);
  options.odometry_heading /= std::sqrt(steps);
  return options;
}

}  // namespace handmap
