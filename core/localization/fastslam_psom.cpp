#include "core/localization/fastslam_psom.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <tbb/parallel_for.h>

#include "core/base/error.h"
#include "core/localization/motion_model.h"
#include "core/localization/resampling.h"
#include "core/localization/wall_likelihood.h"

namespace handmap {

namespace {

// What a stream of random numbers is for; swarms use kSwarms + the index of their building.
constexpr std::uint32_t kMotion = 0;
constexpr std::uint32_t kResampling = 1;
constexpr std::uint32_t kSwarms = 2;

}  // namespace

FastSlamPsom::FastSlamPsom(const Map& drawing, const Pose2& start_odometry,
                           const SlamOptions& options, std::uint64_t seed)
    : drawing_(drawing), options_(options), seed_(seed), odometry_(start_odometry) {
  requireReadyToRun(drawing);
  for (const Building& building : drawing.buildings) models_.emplace_back(building);
  Particle first;
  first.pose = *drawing.start;
  first.weight = 1.0 / options.slam_particles;
  first.map.resize(models_.size());
  particles_.assign(static_cast<std::size_t>(options.slam_particles), first);
}

bool FastSlamPsom::step(double time_s, const Pose2& odometry, const LocalMap& local_map,
                        const std::stop_token& stop, const std::function<void(double)>& progress) {
  const Pose2 motion = between(odometry_, odometry);
  std::vector<Particle> next(particles_.size());
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, next.size(), [&](std::size_t i) {
    if (stop.stop_requested()) return;
    next[i] = advanced(particles_[i], static_cast<std::uint32_t>(i), time_s, motion, local_map);
    const std::size_t ready = ++done;
    if (progress) progress(static_cast<double>(ready) / static_cast<double>(next.size()));
  });
  if (stop.stop_requested()) return false;
  particles_ = std::move(next);
  odometry_ = odometry;
  ++frame_;
  resample();
  return true;
}

Particle FastSlamPsom::advanced(const Particle& particle, std::uint32_t index, double time_s,
                                const Pose2& motion, const LocalMap& local_map) const {
  Particle result = particle;
  // x_t ~ p(x_t | u_t, x_{t-1})
  if (frame_ > 0 || motion != Pose2{}) {
    RandomStream random(seed_, frame_, index, kMotion);
    result.pose = samplePose(particle.pose, motion, options_.motion, random);
  }
  result.path = particle.path.extended({time_s, result.pose});

  const auto visible = visibleBuildings(result, local_map.range());
  double likelihood = 0.0;
  for (const std::size_t building : visible) {
    // m_t,b ← PSO(m_{t-1},b, z_t, x_t)
    result.map[building] = refinedSwarm(result, index, building, local_map);
    likelihood += result.map[building]->best_score;
  }
  // w_t = p(z_t | x_t, m_t): the likelihood with the best latest map
  result.weight = particle.weight * likelihood;
  result.visible = static_cast<int>(visible.size());
  result.plausible = isPlausible(result, visible);
  return result;
}

BuildingState FastSlamPsom::stateOf(const Particle& particle, std::size_t building) const {
  const auto& swarm = particle.map[building];
  return swarm ? swarm->best : models_[building].drawn();
}

std::vector<std::size_t> FastSlamPsom::visibleBuildings(const Particle& particle,
                                                        double range_m) const {
  std::vector<std::size_t> visible;
  for (std::size_t b = 0; b < models_.size(); ++b) {
    const auto& swarm = particle.map[b];
    const BuildingState mean = swarm ? swarm->mean() : models_[b].drawn();
    const double distance = std::hypot(mean.x - particle.pose.x, mean.y - particle.pose.y);
    if (distance < range_m) visible.push_back(b);
  }
  return visible;
}

std::shared_ptr<const Swarm> FastSlamPsom::refinedSwarm(const Particle& particle,
                                                        std::uint32_t index, std::size_t building,
                                                        const LocalMap& local_map) const {
  const Building& drawn = drawing_.buildings[building];
  const WallLikelihood walls(models_[building], particle.pose, local_map);
  const auto score = [&](const BuildingState& state) {
    return discounted(walls(state), options_.effective_ratio);
  };
  RandomStream random(seed_, frame_, index, kSwarms + static_cast<std::uint32_t>(building));
  const bool refine = options_.refine && !drawn.fixed;
  const auto& before = particle.map[building];
  Swarm swarm = before ? *before
                       : sampleSwarm(models_[building].drawn(), drawing_.uncertaintyOf(drawn),
                                     refine ? options_.pso_particles : 0, random);
  if (refine) {
    swarm = refined(std::move(swarm), score, options_, random);
  } else {
    swarm.best_score = score(swarm.best);
  }
  return std::make_shared<const Swarm>(std::move(swarm));
}

bool FastSlamPsom::isPlausible(const Particle& particle,
                               const std::vector<std::size_t>& buildings) const {
  std::vector<Polygon> footprints;
  for (const std::size_t b : buildings) {
    footprints.push_back(models_[b].footprint(stateOf(particle, b)));
    if (contains(footprints.back(), particle.pose.position())) return false;
  }
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    for (std::size_t j = i + 1; j < footprints.size(); ++j) {
      if (!overlap(footprints[i], footprints[j])) continue;
      // Buildings that overlap in the drawing already may go on doing so.
      const auto drawn = [&](std::size_t b) { return models_[b].footprint(models_[b].drawn()); };
      if (!overlap(drawn(buildings[i]), drawn(buildings[j]))) return false;
    }
  }
  return true;
}

void FastSlamPsom::resample() {
  const auto refusing = std::any_of(particles_.begin(), particles_.end(), [](const Particle& p) {
    return p.plausible && p.weight > 0.0;
  });
  std::vector<double> weights;
  for (const Particle& particle : particles_) weights.push_back(particle.weight);
  normalize(weights);
  for (std::size_t i = 0; i < weights.size(); ++i) particles_[i].weight = weights[i];
  const double size = effectiveSampleSize(weights);

  if (refusing) {
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (!particles_[i].plausible) weights[i] = 0.0;
    }
    normalize(weights);
  }
  best_ =
      static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
  last_step_ = {size, particles_[best_].visible};
  const double count = static_cast<double>(weights.size());
  if (size >= options_.resample_below * count) return;

  RandomStream random(seed_, frame_, 0, kResampling);
  const std::vector<int> drawn = systematicResample(weights, random.uniform());
  std::vector<Particle> next;
  next.reserve(particles_.size());
  for (const int i : drawn) {
    next.push_back(particles_[static_cast<std::size_t>(i)]);
    next.back().weight = 1.0 / count;
  }
  // The heaviest weighs at least 1/count, and so is always drawn.
  best_ = static_cast<std::size_t>(std::find(drawn.begin(), drawn.end(), static_cast<int>(best_)) -
                                   drawn.begin());
  particles_ = std::move(next);
}

Estimate FastSlamPsom::estimateOf(std::size_t building, const Swarm& best) const {
  // Spread of the swarms of all particles around the state that is shown.
  double weight = 0.0;
  Estimate estimate;
  for (const Particle& particle : particles_) {
    const auto& swarm = particle.map[building];
    if (!swarm || swarm->members.empty()) continue;
    const double share = particle.weight / static_cast<double>(swarm->members.size());
    for (const SwarmMember& member : swarm->members) {
      estimate.sigma_x += share * std::pow(member.position.x - best.best.x, 2);
      estimate.sigma_y += share * std::pow(member.position.y - best.best.y, 2);
      estimate.sigma_width += share * std::pow(member.position.width - best.best.width, 2);
    }
    weight += particle.weight;
  }
  if (weight <= 0.0) return {0.0, 0.0, 0.0, best.observations};
  return {std::sqrt(estimate.sigma_x / weight), std::sqrt(estimate.sigma_y / weight),
          std::sqrt(estimate.sigma_width / weight), best.observations};
}

Map FastSlamPsom::refinedMap() const {
  Map map = drawing_;
  for (std::size_t b = 0; b < models_.size(); ++b) {
    const auto& swarm = best().map[b];
    if (!swarm || swarm->observations == 0) continue;
    map.buildings[b] = map.buildings[b].fitted(models_[b].box(swarm->best));
    map.buildings[b].estimate = estimateOf(b, *swarm);
  }
  return map;
}

}  // namespace handmap
