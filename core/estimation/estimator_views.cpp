// What the estimator shows.
#include <algorithm>

#include "core/base/random.h"
#include "core/estimation/estimator_state.h"
#include "core/estimation/samples.h"

namespace handmap {

const Pose2& HandmapEstimator::pose() const { return state_->pose; }
const Eigen::Matrix3d& HandmapEstimator::poseCovariance() const { return state_->covariance; }
const DrawingMotion& HandmapEstimator::drawingMotion() const { return state_->labels.motion(); }
const std::vector<FoundBox>& HandmapEstimator::found() const { return state_->found; }

const SharedList<StampedPose>& HandmapEstimator::trajectory() const { return state_->trajectory; }

double HandmapEstimator::effectiveSampleSize() const {
  double squares = 0.0;
  for (const Hypothesis& h : state_->labels.hypotheses()) squares += h.weight * h.weight;
  return 1.0 / squares;
}

int HandmapEstimator::visibleBuildings() const {
  const auto& found = state_->found;
  return static_cast<int>(std::count_if(found.begin(), found.end(), [&](const FoundBox& box) {
    return !state_->frames.empty() && state_->isInSight(box);
  }));
}

namespace {

// Purposes of random streams.
constexpr std::uint32_t kPose = 0;
constexpr std::uint32_t kBuilding = 1;

}  // namespace

std::vector<PoseParticle> HandmapEstimator::particles() const {
  const State& state = *state_;
  const PoseSampler sample(state.pose, state.covariance);
  std::vector<PoseParticle> particles;
  const auto count = static_cast<std::size_t>(state.options.particles);
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(state.seed, static_cast<std::uint32_t>(state.frames.size()),
                        static_cast<std::uint32_t>(i), kPose);
    particles.push_back({sample(random), 1.0 / static_cast<double>(count)});
  }
  return particles;
}

std::vector<BuildingSwarm> HandmapEstimator::swarms(std::size_t members) const {
  const State& state = *state_;
  const std::vector<std::size_t> held = sampledHypotheses(state.labels.hypotheses(), members);
  std::vector<BuildingSwarm> swarms;
  for (const std::size_t b : state.labels.nearby()) {
    const FoundBox* best = state.labels.foundFor(b, state.labels.hypotheses().front(), state.found);
    if (!best || !best->in_sight) continue;
    const Building& drawn = state.drawing.buildings[b];
    BuildingSwarm swarm{b, {}};
    RandomStream random(state.seed, static_cast<std::uint32_t>(state.frames.size()),
                        static_cast<std::uint32_t>(b), kBuilding);
    for (std::size_t i = 0; i < members;) {
      const std::size_t h = held[i];
      const Hypothesis& hypothesis = state.labels.hypotheses()[h];
      const BuildingSampler sample(
          refinedBuilding(drawn, state.drawing.uncertaintyOf(drawn), hypothesis.motion,
                          state.labels.foundFor(b, hypothesis, state.found)));
      for (; i < members && held[i] == h; ++i) swarm.members.push_back(sample(random));
    }
    swarms.push_back(std::move(swarm));
  }
  return swarms;
}

std::function<Map()> HandmapEstimator::refinedMapLater() const {
  return state_->correction.mapLater();
}

}  // namespace handmap
