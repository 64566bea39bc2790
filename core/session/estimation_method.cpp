#include "core/session/estimation_method.h"

#include <cmath>

#include <Eigen/Core>

#include "core/localization/fastslam_psom.h"
#include "core/session/handmap_method.h"

namespace handmap {

namespace {

std::array<double, 3> spreadOf(const std::vector<Particle>& particles) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  const double heading = particles.front().pose.heading;
  const auto vector_of = [heading](const Pose2& pose) {
    return Eigen::Vector3d(pose.x, pose.y, normalizedAngle(pose.heading - heading));
  };
  for (const Particle& particle : particles) mean += particle.weight * vector_of(particle.pose);
  Eigen::Vector3d variance = Eigen::Vector3d::Zero();
  for (const Particle& particle : particles) {
    variance += particle.weight * (vector_of(particle.pose) - mean).cwiseAbs2();
  }
  return {std::sqrt(variance.x()), std::sqrt(variance.y()), std::sqrt(variance.z())};
}

class PaperMethod : public EstimationMethod {
 public:
  PaperMethod(const Map& drawing, const SourceInfo& source, const RunSettings& settings)
      : slam_(drawing, source.start_odometry, settings.slam, settings.seed) {}

  bool step(double time_s, const Pose2& odometry, const Percept& percept,
            const std::stop_token& stop, const std::function<void(double)>& progress) override {
    return slam_.step(time_s, odometry, percept.local_map, stop, progress);
  }
  void describe(FrameReport& report) const override {
    report.effective_sample_size = slam_.lastStep().effective_sample_size;
    report.visible_buildings = slam_.lastStep().visible_buildings;
    report.pose = slam_.best().pose;
    report.pose_sigma = spreadOf(slam_.particles());
  }
  std::vector<ParticleView> particles() const override {
    std::vector<ParticleView> views;
    views.reserve(slam_.particles().size());
    for (const Particle& particle : slam_.particles()) {
      views.push_back({particle.pose, particle.weight});
    }
    return views;
  }
  std::vector<BuildingSwarm> swarms() const override {
    std::vector<BuildingSwarm> swarms;
    for (const std::size_t building : slam_.near()) {
      BuildingSwarm swarm{building, slam_.swarmOf(building, kSwarmMembers)};
      if (!swarm.members.empty()) swarms.push_back(std::move(swarm));
    }
    return swarms;
  }
  SharedList<StampedPose> trajectory() const override {
    return SharedListWriter<StampedPose>(slam_.best().path.poses()).share();
  }
  std::function<Map()> refinedMap() const override {
    return [map = slam_.refinedMap()] { return map; };
  }

 private:
  FastSlamPsom slam_;
};

}  // namespace

std::unique_ptr<EstimationMethod> makeMethod(const Map& drawing, const SourceInfo& source,
                                             const RunSettings& settings) {
  // A fixed map is localized on by the same code as the published method: nothing to refine.
  if (settings.method == Method::Paper || !settings.slam.refine) {
    return std::make_unique<PaperMethod>(drawing, source, settings);
  }
  return makeHandmapMethod(drawing, source, settings);
}

}  // namespace handmap
