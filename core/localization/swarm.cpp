#include "core/localization/swarm.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

/// Members closer to the best than this have met, metres: a tenth of a cell.
constexpr double kMet = 0.01;

constexpr double BuildingState::*kParameters[] = {&BuildingState::x, &BuildingState::y,
                                                  &BuildingState::width};

bool haveMet(const Swarm& swarm) {
  return std::all_of(swarm.members.begin(), swarm.members.end(), [&](const SwarmMember& member) {
    return std::all_of(std::begin(kParameters), std::end(kParameters), [&](auto parameter) {
      return std::abs(member.position.*parameter - swarm.best.*parameter) < kMet;
    });
  });
}

void move(SwarmMember& member, const BuildingState& own_best, const BuildingState& best,
          const SlamOptions& options, RandomStream& random) {
  for (const auto parameter : kParameters) {
    double& velocity = member.velocity.*parameter;
    double& position = member.position.*parameter;
    velocity = options.inertia * velocity +
               options.cognitive * random.uniform() * (own_best.*parameter - position) +
               options.social * random.uniform() * (best.*parameter - position);
    position += velocity;
  }
  member.position.width = std::max(member.position.width, kMinWidth);
}

}  // namespace

BuildingState Swarm::mean() const {
  if (members.empty()) return best;
  BuildingState mean;
  for (const auto parameter : kParameters) {
    for (const SwarmMember& member : members) mean.*parameter += member.position.*parameter;
    mean.*parameter /= static_cast<double>(members.size());
  }
  return mean;
}

Swarm sampleSwarm(const BuildingState& drawn, const Uncertainty& uncertainty, int members,
                  RandomStream& random) {
  Swarm swarm;
  swarm.best = drawn;
  swarm.members.resize(static_cast<std::size_t>(members));
  for (SwarmMember& member : swarm.members) {
    member.position.x = random.normal(drawn.x, uncertainty.position);
    member.position.y = random.normal(drawn.y, uncertainty.position);
    member.position.width = std::max(kMinWidth, random.normal(drawn.width, uncertainty.size));
  }
  return swarm;
}

Swarm refined(Swarm swarm, const BuildingScore& score, const SlamOptions& options,
              RandomStream& random) {
  std::vector<BuildingState> own_best;
  std::vector<double> own_score;
  swarm.best_score = 0.0;
  const auto keep_best = [&](std::size_t i) {
    if (own_score[i] <= swarm.best_score) return;
    swarm.best_score = own_score[i];
    swarm.best = own_best[i];
  };
  for (const SwarmMember& member : swarm.members) {
    own_best.push_back(member.position);
    own_score.push_back(score(member.position));
    keep_best(own_best.size() - 1);
  }
  if (swarm.best_score <= 0.0) return swarm;

  for (int iteration = 0; iteration < options.pso_iterations && !haveMet(swarm); ++iteration) {
    const BuildingState best = swarm.best;
    for (std::size_t i = 0; i < swarm.members.size(); ++i) {
      SwarmMember& member = swarm.members[i];
      move(member, own_best[i], best, options, random);
      const double value = score(member.position);
      if (value <= own_score[i]) continue;
      own_score[i] = value;
      own_best[i] = member.position;
      keep_best(i);
    }
  }
  ++swarm.observations;
  return swarm;
}

}  // namespace handmap
