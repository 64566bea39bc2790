// What the estimator shows.
#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/estimation/constants.h"
#include "core/estimation/estimator_state.h"
#include "core/estimation/samples.h"
#include "core/map/certainty.h"

namespace handmap {

using namespace estimation;

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

/// Purposes of random streams.
enum Purpose : std::uint32_t { kPose = 0, kBuilding = 1 };

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

std::vector<NearbyBuilding> HandmapEstimator::nearby() const {
  std::vector<NearbyBuilding> buildings;
  for (const std::size_t b : state_->labels.nearby()) {
    const Building& now = state_->correction.corrected(b);
    buildings.push_back({b, now.footprint(), isRecognised(now) && !now.fixed});
  }
  return buildings;
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

void HandmapEstimator::watch(std::function<void(EstimatorPhase)> watch) {
  state_->watch = std::move(watch);
}

std::optional<std::size_t> HandmapEstimator::drawnOf(FoundId found) const {
  return state_->labels.drawnOf(found);
}

std::vector<FoundWall> HandmapEstimator::walls() const {
  if (state_->frames.empty()) return {};
  return detectWalls(state_->evidence.evidence(), state_->frames.back().pose.position(),
                     state_->options.range_limit_m);
}

/// Whatever the direction of the wall: the strongest counts.
LocalMap HandmapEstimator::evidence() const {
  const State& state = *state_;
  LocalMap map(walls::kCell_m, state.options.range_limit_m);
  if (state.frames.empty()) return map;
  const Pose2& robot = state.frames.back().pose;
  for (int row = 0; row < map.cells().rows; ++row) {
    for (int column = 0; column < map.cells().cols; ++column) {
      const Vec2 own((column + 0.5) * map.cell() - map.range(),
                     (row + 0.5) * map.cell() - map.range());
      const Vec2 at = robot.toOuter(own);
      for (const WallImage& image : state_->evidence.evidence().images()) {
        const double nats =
            image.at(static_cast<int>(std::floor(image.along().dot(at) / image.cell())),
                     static_cast<int>(std::floor(image.across().dot(at) / image.cell())));
        float& cell = map.cells()(row, column);
        cell = std::max(cell, std::min(static_cast<float>(nats) / kSureCell, 1.0F));
      }
    }
  }
  return map;
}

double HandmapEstimator::logLikelihood() const {
  const State& state = *state_;
  if (state.frames.empty()) return 0.0;
  const Frame* const newest = &state.frames.back();
  double sum = 0.0;
  for (const FoundBox& box : state.found) {
    if (!state.isInSight(box)) continue;
    sum += BoxScorer(box.box, {&newest, 1}, state.sensor, 1)(box.box);
  }
  return sum;
}

std::function<Map()> HandmapEstimator::refinedMapLater() const {
  return state_->correction.mapLater();
}

std::function<Map()> HandmapEstimator::predictedMapLater() const {
  return state_->correction.predictedLater();
}

}  // namespace handmap
