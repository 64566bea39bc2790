// Particle swarm optimization of one building (paper, III; Kennedy & Eberhart 1995).
#pragma once

#include <array>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/random.h"
#include "core/fastslam/building_model.h"
#include "core/fastslam/slam_options.h"
#include "core/map/map.h"

namespace handmap {

/// Buildings are never narrower than this, metres.
inline constexpr double kMinWidth = 1.0;

/// One building of one map: hypotheses about it, and the best of them.
class Swarm {
 public:
  /// x and y of the centre are told from the drawn one, so that single precision is enough.
  enum Parameter { X, Y, Width, Count };
  using Values = std::array<float, Count>;

  /// All members at rest at zero.
  explicit Swarm(std::size_t members) : members_(members), values_(2 * Count * members) {}

  std::size_t members() const { return members_; }
  /// One value a member, metres; of velocities metres an iteration.
  std::span<float> positions(int parameter) { return array(parameter); }
  std::span<float> velocities(int parameter) { return array(Count + parameter); }
  std::span<const float> positions(int parameter) const {
    return {values_.data() + static_cast<std::size_t>(parameter) * members_, members_};
  }
  Values member(std::size_t index) const {
    return {positions(X)[index], positions(Y)[index], positions(Width)[index]};
  }

  Values best{};
  float best_score = 0.0F;  ///< of the last refinement; 0: never hit
  int observations = 0;     ///< refinements that hit a wall
  Values mean{};            ///< of the positions
  Values variance{};

  /// After the members were moved.
  void updateMoments();

 private:
  std::span<float> array(int index) {
    return {values_.data() + static_cast<std::size_t>(index) * members_, members_};
  }

  std::size_t members_;
  std::vector<float> values_;  ///< positions of each parameter, then velocities
};

/// Members drawn from a Gaussian around the drawing; the drawing is the best until one is scored.
Swarm sampleSwarm(double drawn_width, const Uncertainty& uncertainty, int members,
                  RandomStream& random);

/// Scores every member.
using SwarmScore = std::function<void(const Swarm& swarm, std::span<float> scores)>;

/// Called with the swarm as it is: before the first iteration and after each.
using SwarmWatch = std::function<void(const Swarm& swarm)>;

/// v ← w v + c₁ r₁ (p − x) + c₂ r₂ (g − x), x ← x + v, at most `pso_iterations` times or until the
/// members have met. Scores of earlier observations are forgotten: p and g start anew. Ends early,
/// without a meaning, when `stop` was requested.
void refine(Swarm& swarm, const SwarmScore& score, const SlamOptions& options, RandomStream& random,
            const std::stop_token& stop = {}, const SwarmWatch& watch = {});

}  // namespace handmap
