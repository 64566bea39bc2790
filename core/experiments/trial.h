// One trial of the paper's experiments: a scene, a drawing of it, a run, and how far that is off.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/session/run_session.h"
#include "core/simulation/world.h"

namespace handmap {

/// What decides the outcome of every trial of a folder.
struct TrialSettings {
  std::uint64_t seed = 1;
  int slam_particles = SlamOptions{}.slam_particles;
  int pso_particles = SlamOptions{}.pso_particles;
  Keeping keeping = Keeping::SideAndOrder;
  Like like = Like::Sigma;  ///< People: places are off by σ, nothing is missing
};

/// Trial `number` has the scene and the noise of seed + number, whatever the method and σ: methods
/// are compared on the same drives.
struct TrialKey {
  Method method = Method::Handmap;
  double sigma_m = 0.0;  ///< error of the drawing
  int number = 0;
  auto operator<=>(const TrialKey&) const = default;  // NOLINT(modernize-use-nullptr)
};

/// Signed errors as in BuildingError, of the map as it is: the start is known.
struct TrialBuilding {
  std::array<double, 3> drawn{};  ///< x, front, width; metres
  std::array<double, 3> found{};
  double iou = 0.0;
  bool overlaps = false;
};

/// What was known at an observation: errors in metres.
struct TrialStep {
  double pose = 0.0;
  double odometry = 0.0;  ///< of the odometry alone
  double map = 0.0;       ///< mean of |x|, |front| and |width| over the buildings
};

struct Trial {
  static constexpr std::array<const char*, 6> kBuildings = {"N1", "N2", "N3", "S1", "S2", "S3"};
  static constexpr double kStrictIou = 0.5;

  TrialKey key;
  std::array<TrialBuilding, kBuildings.size()> buildings;
  std::vector<TrialStep> way;  ///< one every stepLength()
  static double stepLength();  ///< metres driven between two steps of the way

  bool loose() const;   ///< success as the paper has it: every building overlaps its true one
  bool strict() const;  ///< every building has an IoU of at least kStrictIou
};

/// What a trial is made of.
struct TrialScene {
  World world;
  Map drawing;
  RunSettings run;  ///< on one thread
};
TrialScene sceneOf(const TrialKey& key, const TrialSettings& settings);

/// On one thread. nullopt where `stop` was requested.
std::optional<Trial> runTrial(const TrialKey& key, const TrialSettings& settings,
                              const std::stop_token& stop);

}  // namespace handmap
