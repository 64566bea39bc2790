// Algorithm 1 in its plainest form: one thread, a vector of swarms a particle, every building
// looked at, walls read cell by cell. What FastSlamPsom is checked against and measured by.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/fastslam/motion_model.h"
#include "core/fastslam/resampling.h"
#include "core/fastslam/swarm.h"
#include "tests/core/fastslam/direct_likelihood.h"

namespace handmap::test {

class DirectFastSlam {
 public:
  DirectFastSlam(const Map& drawing, const Pose2& start_odometry, const SlamOptions& options,
                 std::uint64_t seed)
      : drawing_(drawing), options_(options), seed_(seed), odometry_(start_odometry) {
    for (const Building& building : drawing.buildings) models_.emplace_back(building);
    const auto count = static_cast<std::size_t>(options.slam_particles);
    particles_.assign(count, Particle{*drawing.start, 1.0 / options.slam_particles, {}});
    for (Particle& particle : particles_) particle.map.resize(models_.size());
  }

  void step(const Pose2& odometry, const LocalMap& local_map) {
    const Pose2 motion = between(odometry_, odometry);
    for (std::uint32_t i = 0; i < particles_.size(); ++i) {
      advance(particles_[i], i, motion, local_map);
    }
    odometry_ = odometry;
    ++frame_;
    resample();
  }

  /// The state of a building, of the heaviest particle.
  BuildingState best(std::size_t building) const {
    const Particle& best =
        *std::max_element(particles_.begin(), particles_.end(),
                          [](const Particle& a, const Particle& b) { return a.weight < b.weight; });
    return best.map[building] ? stateOf(building, best.map[building]->best)
                              : models_[building].drawn();
  }
  Pose2 meanPose() const {
    Pose2 mean;
    for (const Particle& particle : particles_) {
      mean.x += particle.weight * particle.pose.x;
      mean.y += particle.weight * particle.pose.y;
      mean.heading += particle.weight * particle.pose.heading;
    }
    return mean;
  }

 private:
  struct Particle {
    Pose2 pose;
    double weight;
    std::vector<std::shared_ptr<const Swarm>> map;
    bool plausible = true;
  };

  BuildingState stateOf(std::size_t building, const Swarm::Values& values) const {
    const BuildingState& drawn = models_[building].drawn();
    return {drawn.x + static_cast<double>(values[Swarm::X]),
            drawn.y + static_cast<double>(values[Swarm::Y]),
            static_cast<double>(values[Swarm::Width])};
  }

  void advance(Particle& particle, std::uint32_t index, const Pose2& motion,
               const LocalMap& local_map) const {
    if (frame_ > 0 || motion != Pose2{}) {
      RandomStream random(seed_, frame_, index, 0);
      particle.pose = samplePose(particle.pose, motion, options_.motion, random);
    }
    double likelihood = 0.0;
    std::vector<std::size_t> visible;
    for (std::size_t b = 0; b < models_.size(); ++b) {
      const BuildingState mean =
          particle.map[b] ? stateOf(b, particle.map[b]->mean) : models_[b].drawn();
      const double distance = std::hypot(mean.x - particle.pose.x, mean.y - particle.pose.y);
      if (distance >= local_map.range()) continue;
      visible.push_back(b);
      const DirectLikelihood walls(models_[b], particle.pose, local_map);
      if (!options_.refine) {
        likelihood +=
            static_cast<double>(discounted(walls(models_[b].drawn()), options_.effective_ratio));
        continue;
      }
      RandomStream random(seed_, frame_, index, 2 + static_cast<std::uint32_t>(b));
      Swarm swarm = particle.map[b] ? *particle.map[b]
                                    : sampleSwarm(models_[b].drawn().width,
                                                  drawing_.uncertaintyOf(drawing_.buildings[b]),
                                                  options_.pso_particles, random);
      const auto score = [&](const Swarm& members, std::span<float> scores) {
        for (std::size_t i = 0; i < scores.size(); ++i) {
          const WallCells cells = walls(stateOf(b, members.member(i)));
          scores[i] = discounted(cells, options_.effective_ratio);
        }
      };
      refine(swarm, score, options_, random);
      likelihood += static_cast<double>(swarm.best_score);
      particle.map[b] = std::make_shared<const Swarm>(std::move(swarm));
    }
    particle.weight *= likelihood;
    particle.plausible = isPlausible(particle, visible);
  }

  bool isPlausible(const Particle& particle, const std::vector<std::size_t>& visible) const {
    std::vector<Polygon> refined;
    std::vector<Polygon> drawn;
    for (const std::size_t b : visible) {
      drawn.push_back(models_[b].footprint(models_[b].drawn()));
      refined.push_back(particle.map[b] ? models_[b].footprint(stateOf(b, particle.map[b]->best))
                                        : drawn.back());
      if (contains(refined.back(), particle.pose.position())) return false;
    }
    for (std::size_t i = 0; i < refined.size(); ++i) {
      for (std::size_t j = i + 1; j < refined.size(); ++j) {
        if (overlap(refined[i], refined[j]) && !overlap(drawn[i], drawn[j])) return false;
      }
    }
    return true;
  }

  void resample() {
    std::vector<double> weights;
    for (const Particle& particle : particles_) weights.push_back(particle.weight);
    normalize(weights);
    for (std::size_t i = 0; i < weights.size(); ++i) particles_[i].weight = weights[i];
    const double count = static_cast<double>(weights.size());
    const double size = effectiveSampleSize(weights);
    const bool refusing = std::any_of(particles_.begin(), particles_.end(), [](const Particle& p) {
      return p.plausible && p.weight > 0.0;
    });
    for (std::size_t i = 0; refusing && i < weights.size(); ++i) {
      if (!particles_[i].plausible) weights[i] = 0.0;
    }
    normalize(weights);
    if (size >= options_.resample_below * count) return;
    RandomStream random(seed_, frame_, 0, 1);
    std::vector<Particle> next;
    for (const int i : systematicResample(weights, random.uniform())) {
      next.push_back(particles_[static_cast<std::size_t>(i)]);
      next.back().weight = 1.0 / count;
    }
    particles_ = std::move(next);
  }

  Map drawing_;
  SlamOptions options_;
  std::uint64_t seed_;
  std::vector<BuildingModel> models_;
  std::vector<Particle> particles_;
  Pose2 odometry_;
  std::uint32_t frame_ = 0;
};

}  // namespace handmap::test
