#include "core/fastslam/fastslam_psom.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/fastslam/motion_model.h"
#include "core/fastslam/resampling.h"
#include "core/fastslam/wall_likelihood.h"
#include "core/map/certainty.h"
#include "core/odometry/odometry_noise.h"

namespace handmap {

namespace {

// What a stream of random numbers is for; swarms use kSwarms + the index of their building.
constexpr std::uint32_t kMotion = 0;
constexpr std::uint32_t kStart = 0xffffffff;
constexpr std::uint32_t kGuess = 0xfffffffe;
constexpr std::uint32_t kResampling = 1;
constexpr std::uint32_t kSwarms = 2;

std::vector<SlamTrace::WeighedPose> weighed(const std::vector<Particle>& particles) {
  std::vector<SlamTrace::WeighedPose> poses;
  poses.reserve(particles.size());
  for (const Particle& particle : particles) poses.push_back({particle.pose, particle.weight});
  return poses;
}

}  // namespace

FastSlamPsom::FastSlamPsom(const Map& drawing, const Pose2& start_odometry,
                           const SlamOptions& options, std::uint64_t seed)
    : drawing_(drawing), options_(options), seed_(seed), odometry_(start_odometry) {
  requireReadyToRun(drawing);
  for (const Building& building : drawing.buildings) {
    by_x_.push_back(models_.size());
    models_.emplace_back(building);
  }
  std::sort(by_x_.begin(), by_x_.end(), [&](std::size_t a, std::size_t b) {
    return models_[a].drawn().x < models_[b].drawn().x;
  });
  Particle first;
  first.pose = *drawing.start;
  first.weight = 1.0 / options.slam_particles;
  first.map = SwarmMap(models_.size());
  particles_.assign(static_cast<std::size_t>(options.slam_particles), first);
  if (drawing.start_uncertainty) scatter(*drawing.start_uncertainty);
}

/// The paper takes the start for known. Particles of a start that is not lie as it may lie; the
/// first is where it is drawn.
void FastSlamPsom::scatter(const StartUncertainty& start) {
  for (std::size_t i = 1; i < particles_.size(); ++i) {
    RandomStream random(seed_, 0, static_cast<std::uint32_t>(i), kStart);
    Pose2& pose = particles_[i].pose;
    pose.x += random.normal(0.0, start.position);
    pose.y += random.normal(0.0, start.position);
    pose.heading = normalizedAngle(pose.heading + random.normal(0.0, start.heading));
  }
}

bool FastSlamPsom::step(double time_s, const Odometry& odometry, const LocalMap& local_map,
                        const std::stop_token& stop, const std::function<void(double)>& progress,
                        SlamTrace* trace) {
  samplePoses(time_s, odometry);
  if (trace != nullptr) {
    trace->predicted = weighed(next_);
    trace->watched = best_;
  }
  near_ = buildingsNear(local_map.range());
  sums_.reset(local_map);
  const std::vector<std::size_t> order = byHeading();
  std::atomic<std::size_t> done = 0;
  parallelFor(next_.size(), [&](std::size_t place) {
    if (stop.stop_requested()) return;
    const std::size_t i = order[place];
    SlamTrace* const watching = trace != nullptr && trace->watched == i ? trace : nullptr;
    updateMap(next_[i], static_cast<std::uint32_t>(i), local_map.range(), stop, watching);
    const std::size_t before = done++;
    const auto percent = [&](std::size_t count) { return 100 * count / next_.size(); };
    if (!progress || percent(before) == percent(before + 1)) return;
    progress(static_cast<double>(before + 1) / static_cast<double>(next_.size()));
  });
  if (stop.stop_requested()) return false;
  particles_.swap(next_);
  odometry_ = odometry;
  ++frame_;
  resample(trace);
  return true;
}

void FastSlamPsom::samplePoses(double time_s, const Odometry& odometry) {
  next_.resize(particles_.size());
  const Pose2 motion = between(odometry_.pose, odometry.pose);
  const Eigen::Matrix3d guessed = guessedOf(odometry_, odometry);
  const bool moved = frame_ > 0 || motion != Pose2{};
  parallelFor(next_.size(), [&](std::size_t i) {
    Particle& particle = next_[i];
    particle = particles_[i];
    // x_t ~ p(x_t | u_t, x_{t-1})
    if (moved) {
      const auto index = static_cast<std::uint32_t>(i);
      RandomStream random(seed_, frame_, index, kMotion);
      RandomStream guess(seed_, frame_, index, kGuess);
      const Pose2 driven = guessed.isZero() ? motion : sampleGuess(motion, guessed, guess);
      particle.pose = samplePose(particle.pose, driven, options_.motion, random);
    }
    particle.path = particle.path.extended({time_s, particle.pose});
  });
}

/// Particles one after the other that read the same lines find them in the cache.
std::vector<std::size_t> FastSlamPsom::byHeading() const {
  const auto bucket = [&](const Particle& particle) {
    const int steps = LineDirection::stepsOf(particle.pose.heading) + LineDirection::kHalfTurn;
    return static_cast<std::size_t>(std::clamp(steps, 0, 2 * LineDirection::kHalfTurn));
  };
  std::vector<std::size_t> next_place(2 * LineDirection::kHalfTurn + 2);
  for (const Particle& particle : next_) ++next_place[bucket(particle) + 1];
  std::partial_sum(next_place.begin(), next_place.end(), next_place.begin());
  std::vector<std::size_t> order(next_.size());
  for (std::size_t i = 0; i < next_.size(); ++i) order[next_place[bucket(next_[i])]++] = i;
  return order;
}

/// All that any particle may see, and some more; ascending.
std::vector<std::size_t> FastSlamPsom::buildingsNear(double range_m) const {
  const double reach = range_m + farthest_moved_;
  Bounds area{next_.front().pose.position(), next_.front().pose.position()};
  for (const Particle& particle : next_) {
    area.low = area.low.cwiseMin(particle.pose.position());
    area.high = area.high.cwiseMax(particle.pose.position());
  }
  const auto first = std::partition_point(by_x_.begin(), by_x_.end(), [&](std::size_t b) {
    return models_[b].drawn().x < area.low.x() - reach;
  });
  std::vector<std::size_t> near;
  for (auto b = first; b != by_x_.end(); ++b) {
    const BuildingState& drawn = models_[*b].drawn();
    if (drawn.x > area.high.x() + reach) break;
    if (drawn.y < area.low.y() - reach || drawn.y > area.high.y() + reach) continue;
    near.push_back(*b);
  }
  std::sort(near.begin(), near.end());
  return near;
}

void FastSlamPsom::updateMap(Particle& particle, std::uint32_t index, double range_m,
                             const std::stop_token& stop, SlamTrace* trace) {
  const Vec2 ahead = unitVector(particle.pose.heading);
  std::vector<Visible> visible;
  visible.reserve(near_.size());
  double likelihood = 0.0;
  for (const std::size_t building : near_) {
    const Swarm* swarm = particle.map.find(building);
    const BuildingState mean = swarm ? stateOf(building, swarm->mean) : models_[building].drawn();
    const Vec2 offset(mean.x - particle.pose.x, mean.y - particle.pose.y);
    if (offset.squaredNorm() >= range_m * range_m) continue;
    // m_t,b ← PSO(m_{t-1},b, z_t, x_t)
    visible.push_back({building, models_[building].drawn(), false});
    likelihood += refineBuilding(particle, index, ahead, visible.back(), stop, trace);
  }
  // w_t = p(z_t | x_t, m_t): the likelihood with the best latest map
  particle.weight *= likelihood;
  particle.visible = static_cast<int>(visible.size());
  particle.plausible = isPlausible(particle.pose, visible);
}

/// The score of the best state.
double FastSlamPsom::refineBuilding(Particle& particle, std::uint32_t index, const Vec2& ahead,
                                    Visible& seen, const std::stop_token& stop, SlamTrace* trace) {
  const Building& drawn = drawing_.buildings[seen.building];
  const BuildingModel& model = models_[seen.building];
  const WallLikelihood walls(model, particle.pose, ahead, sums_);
  const auto score = [&](float x, float y, float width) {
    return discounted(walls(x, y, width), options_.effective_ratio);
  };
  if (!options_.refine || drawn.fixed) {
    return static_cast<double>(score(0.0F, 0.0F, static_cast<float>(model.drawn().width)));
  }
  const auto scores = [&](const Swarm& swarm, std::span<float> values) {
    const auto x = swarm.positions(Swarm::X);
    const auto y = swarm.positions(Swarm::Y);
    const auto width = swarm.positions(Swarm::Width);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = score(x[i], y[i], width[i]);
    }
  };

  RandomStream random(seed_, frame_, index, kSwarms + static_cast<std::uint32_t>(seen.building));
  const Swarm* before = particle.map.find(seen.building);
  auto swarm = std::make_shared<Swarm>(before ? *before
                                              : sampleSwarm(model.drawn().width,
                                                            drawing_.uncertaintyOf(drawn),
                                                            options_.pso_particles, random));
  refine(*swarm, scores, options_, random, stop, watchOf(seen.building, trace));
  seen.state = stateOf(seen.building, swarm->best);
  seen.refined = true;
  const auto moved = static_cast<double>(std::hypot(swarm->mean[Swarm::X], swarm->mean[Swarm::Y]));
  for (double most = farthest_moved_; moved > most;) {
    if (farthest_moved_.compare_exchange_weak(most, moved)) break;
  }
  const auto result = static_cast<double>(swarm->best_score);
  particle.map.set(seen.building, std::move(swarm));
  return result;
}

/// Of the building of the particle that is looked at; empty where none is.
SwarmWatch FastSlamPsom::watchOf(std::size_t building, SlamTrace* trace) const {
  if (trace == nullptr) return {};
  trace->buildings.push_back({building, {}});
  return [this, trace, building](const Swarm& swarm) {
    SlamTrace::Iteration iteration;
    for (std::size_t i = 0; i < swarm.members(); ++i) {
      iteration.members.push_back(models_[building].box(stateOf(building, swarm.member(i))));
    }
    iteration.best = models_[building].box(stateOf(building, swarm.best));
    iteration.best_score = static_cast<double>(swarm.best_score);
    trace->buildings.back().iterations.push_back(std::move(iteration));
  };
}

BuildingState FastSlamPsom::stateOf(std::size_t building, const Swarm::Values& values) const {
  const BuildingState& drawn = models_[building].drawn();
  return {drawn.x + static_cast<double>(values[Swarm::X]),
          drawn.y + static_cast<double>(values[Swarm::Y]),
          static_cast<double>(values[Swarm::Width])};
}

bool FastSlamPsom::isPlausible(const Pose2& robot, const std::vector<Visible>& visible) const {
  const auto footprint = [&](const Visible& seen) {
    return models_[seen.building].footprint(seen.state);
  };
  const auto drawn = [&](const Visible& seen) {
    return models_[seen.building].footprint(models_[seen.building].drawn());
  };
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const Visible& a = visible[i];
    const BuildingModel& model = models_[a.building];
    if (model.mayHold(a.state, robot.position()) && contains(footprint(a), robot.position())) {
      return false;
    }
    for (std::size_t j = i + 1; j < visible.size(); ++j) {
      const Visible& b = visible[j];
      // Buildings that overlap in the drawing already may go on doing so.
      if (!a.refined && !b.refined) continue;
      if (model.isApart(a.state, models_[b.building], b.state)) continue;
      if (overlap(footprint(a), footprint(b)) && !overlap(drawn(a), drawn(b))) return false;
    }
  }
  return true;
}

void FastSlamPsom::resample(SlamTrace* trace) {
  const auto refusing = std::any_of(particles_.begin(), particles_.end(), [](const Particle& p) {
    return p.plausible && p.weight > 0.0;
  });
  std::vector<double> weights;
  for (const Particle& particle : particles_) weights.push_back(particle.weight);
  const double likelihood = std::accumulate(weights.begin(), weights.end(), 0.0);
  normalize(weights);
  for (std::size_t i = 0; i < weights.size(); ++i) particles_[i].weight = weights[i];
  if (trace != nullptr) trace->weighed = weighed(particles_);
  const double size = effectiveSampleSize(weights);

  if (refusing) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (!particles_[i].plausible) weights[i] = 0.0;
    }
    normalize(weights);
  }
  best_ =
      static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  last_step_ = {size, particles_[best_].visible, likelihood};
  const double count = static_cast<double>(weights.size());
  if (size >= options_.resample_below * count) return;

  RandomStream random(seed_, frame_, 0, kResampling);
  const std::vector<int> drawn = systematicResample(weights, random.uniform());
  if (trace != nullptr) {
    trace->resampled = true;
    trace->survivors = std::set<int>(drawn.begin(), drawn.end()).size();
  }
  parallelFor(drawn.size(), [&](std::size_t i) {
    next_[i] = particles_[static_cast<std::size_t>(drawn[i])];
    next_[i].weight = 1.0 / count;
  });
  // The heaviest weighs at least 1/count, and so is always drawn.
  best_ = static_cast<std::size_t>(std::find(drawn.begin(), drawn.end(), static_cast<int>(best_)) -
                                   drawn.begin());
  particles_.swap(next_);
}

Estimate FastSlamPsom::estimateOf(std::size_t building, const Swarm& best) const {
  // Spread of the swarms of all particles around the state that is shown.
  double weight = 0.0;
  std::array<double, Swarm::Count> squares{};
  for (const Particle& particle : particles_) {
    const Swarm* swarm = particle.map.find(building);
    if (swarm == nullptr) continue;
    for (std::size_t p = 0; p < squares.size(); ++p) {
      const auto off = static_cast<double>(swarm->mean[p] - best.best[p]);
      squares[p] += particle.weight * (static_cast<double>(swarm->variance[p]) + off * off);
    }
    weight += particle.weight;
  }
  if (weight <= 0.0) return {0.0, 0.0, 0.0, best.observations};
  return {std::sqrt(squares[Swarm::X] / weight), std::sqrt(squares[Swarm::Y] / weight),
          std::sqrt(squares[Swarm::Width] / weight), best.observations};
}

std::vector<Rectangle> FastSlamPsom::swarmOf(std::size_t building, std::size_t most) const {
  std::vector<Rectangle> members;
  const Swarm* swarm = best().map.find(building);
  if (swarm == nullptr || swarm->observations == 0) return members;
  const std::size_t stride = (swarm->members() + most - 1) / most;
  for (std::size_t i = 0; i < swarm->members(); i += stride) {
    members.push_back(models_[building].box(stateOf(building, swarm->member(i))));
  }
  return members;
}

Map FastSlamPsom::refinedMap() const {
  Map map = drawing_;
  for (std::size_t b = 0; b < models_.size(); ++b) {
    const Swarm* swarm = best().map.find(b);
    if (swarm == nullptr || swarm->observations == 0) continue;
    map.buildings[b] = map.buildings[b].fitted(models_[b].box(stateOf(b, swarm->best)));
    map.buildings[b].estimate = estimateOf(b, *swarm);
    forgetCertainty(map.buildings[b]);  // of an earlier run
  }
  return map;
}

}  // namespace handmap
