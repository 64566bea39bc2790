#include "core/fastslam/swarm.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

/// Members closer to the best than this have met, metres: a tenth of a cell.
constexpr float kMet = 0.01F;

bool haveMet(const Swarm& swarm) {
  int apart = 0;
  for (int parameter = 0; parameter < Swarm::Count; ++parameter) {
    const float best = swarm.best[static_cast<std::size_t>(parameter)];
    for (const float position : swarm.positions(parameter)) {
      apart |= static_cast<int>(std::abs(position - best) >= kMet);
    }
  }
  return apart == 0;
}

/// The best position of every member, and its score.
class OwnBests {
 public:
  explicit OwnBests(const Swarm& swarm)
      : count_(swarm.members()), values_((Swarm::Count + 2) * count_) {
    for (int parameter = 0; parameter < Swarm::Count; ++parameter) {
      std::ranges::copy(swarm.positions(parameter), array(parameter).begin());
    }
  }

  std::span<const float> positions(int parameter) { return array(parameter); }

  /// Scores every member; a better position than any before becomes its best, and the swarm's.
  void update(Swarm& swarm, const SwarmScore& score) {
    const std::span<float> best = array(Swarm::Count);
    const std::span<float> scores = array(Swarm::Count + 1);
    score(swarm, scores);
    for (std::size_t i = 0; i < count_; ++i) {
      if (scores[i] <= best[i]) continue;
      best[i] = scores[i];
      const Swarm::Values member = swarm.member(i);
      for (std::size_t p = 0; p < member.size(); ++p) values_[p * count_ + i] = member[p];
      if (best[i] <= swarm.best_score) continue;
      swarm.best_score = best[i];
      swarm.best = member;
    }
  }

 private:
  std::span<float> array(int index) {
    return {values_.data() + static_cast<std::size_t>(index) * count_, count_};
  }

  std::size_t count_;
  std::vector<float> values_;  ///< positions of each parameter, their scores, the newest scores
};

/// `numbers`: two a member.
void move(Swarm& swarm, int parameter, std::span<const float> own_best, const float* numbers,
          const SlamOptions& options) {
  const auto inertia = static_cast<float>(options.inertia);
  const auto cognitive = static_cast<float>(options.cognitive);
  const auto social = static_cast<float>(options.social);
  const float best = swarm.best[static_cast<std::size_t>(parameter)];
  const std::size_t count = swarm.members();
  float* positions = swarm.positions(parameter).data();
  float* velocities = swarm.velocities(parameter).data();
  for (std::size_t i = 0; i < count; ++i) {
    velocities[i] = inertia * velocities[i] +
                    cognitive * numbers[i] * (own_best[i] - positions[i]) +
                    social * numbers[count + i] * (best - positions[i]);
    positions[i] += velocities[i];
  }
}

void keepWide(std::span<float> widths) {
  for (float& width : widths) width = std::max(width, static_cast<float>(kMinWidth));
}

}  // namespace

void Swarm::updateMoments() {
  if (members_ == 0) return;
  const auto count = static_cast<float>(members_);
  for (int parameter = 0; parameter < Count; ++parameter) {
    float sum = 0.0F;
    for (const float position : positions(parameter)) sum += position;
    const float middle = sum / count;
    float squares = 0.0F;
    for (const float position : positions(parameter)) {
      squares += (position - middle) * (position - middle);
    }
    mean[static_cast<std::size_t>(parameter)] = middle;
    variance[static_cast<std::size_t>(parameter)] = squares / count;
  }
}

Swarm sampleSwarm(double drawn_width, const Uncertainty& uncertainty, int members,
                  RandomStream& random) {
  Swarm swarm(static_cast<std::size_t>(members));
  for (std::size_t i = 0; i < swarm.members(); ++i) {
    swarm.positions(Swarm::X)[i] = static_cast<float>(random.normal(0.0, uncertainty.position));
    swarm.positions(Swarm::Y)[i] = static_cast<float>(random.normal(0.0, uncertainty.position));
    swarm.positions(Swarm::Width)[i] =
        static_cast<float>(random.normal(drawn_width, uncertainty.size));
  }
  keepWide(swarm.positions(Swarm::Width));
  swarm.best[Swarm::Width] = static_cast<float>(drawn_width);
  swarm.updateMoments();
  return swarm;
}

void refine(Swarm& swarm, const SwarmScore& score, const SlamOptions& options, RandomStream& random,
            const std::stop_token& stop, const SwarmWatch& watch) {
  OwnBests own_bests(swarm);
  swarm.best_score = 0.0F;
  own_bests.update(swarm, score);
  if (watch) watch(swarm);
  if (swarm.best_score <= 0.0F) return;

  std::vector<float> numbers;
  for (int iteration = 0; iteration < options.pso_iterations && !haveMet(swarm); ++iteration) {
    if (stop.stop_requested()) return;
    numbers.resize(2 * Swarm::Count * swarm.members());
    random.uniforms(numbers);
    for (int parameter = 0; parameter < Swarm::Count; ++parameter) {
      move(swarm, parameter, own_bests.positions(parameter),
           numbers.data() + 2 * static_cast<std::size_t>(parameter) * swarm.members(), options);
    }
    keepWide(swarm.positions(Swarm::Width));
    own_bests.update(swarm, score);
    if (watch) watch(swarm);
  }
  ++swarm.observations;
  swarm.updateMoments();
}

}  // namespace handmap
