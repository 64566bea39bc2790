#include "core/method/paper_method.h"

#include <cmath>

#include <Eigen/Core>

#include "core/explain/seen_walls.h"
#include "core/fastslam/fastslam_psom.h"
#include "core/method/constants.h"
#include "core/method/paper_phases.h"
#include "core/method/pose_trust.h"
#include "core/method/recognition.h"

namespace handmap {

namespace {

Eigen::Matrix3d covarianceOf(const std::vector<Particle>& particles, const Pose2& stated) {
  const auto vector_of = [&](const Pose2& pose) {
    return Eigen::Vector3d(pose.x - stated.x, pose.y - stated.y,
                           normalizedAngle(pose.heading - stated.heading));
  };
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Particle& particle : particles) {
    const Eigen::Vector3d off = vector_of(particle.pose);
    covariance += particle.weight * off * off.transpose();
  }
  return covariance;
}

class PaperMethod : public EstimationMethod {
 public:
  PaperMethod(const Map& drawing, const SourceInfo& source, const RunSettings& settings)
      : drawing_(std::make_shared<const Map>(drawing)),
        slam_(drawing, source.start_odometry, settings.slam, settings.seed) {}

  bool step(double time_s, const Odometry& odometry, const Percept& percept,
            const LazyLocalMap& local_map, const std::stop_token& stop,
            const std::function<void(double)>& progress) override {
    SlamTrace trace;
    const Pose2 before = slam_.best().pose;
    if (!slam_.step(time_s, odometry, local_map, stop, progress, recorder_ ? &trace : nullptr)) {
      return false;
    }
    const double driven_m = (slam_.best().pose.position() - before.position()).norm();
    recognition_.look(
        wall_rays_.add(outlinesOf(slam_.refinedMap()), slam_.best().pose, percept.scan), driven_m,
        odometry.guessed);
    if (recorder_ != nullptr) {
      tellPhases(trace, {slam_, *drawing_, local_map, before}, *recorder_);
    }
    return true;
  }
  void trace(PhaseRecorder* recorder) override { recorder_ = recorder; }
  void describe(FrameReport& report) const override {
    report.effective_sample_size = slam_.lastStep().effective_sample_size;
    report.visible_buildings = slam_.lastStep().visible_buildings;
    if (slam_.lastStep().likelihood > 0.0) {
      report.log_likelihood = std::log(slam_.lastStep().likelihood);
    }
    report.pose = slam_.best().pose;
    recognition_.state(covarianceOf(slam_.particles(), report.pose), report);
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
      BuildingSwarm swarm{building, slam_.swarmOf(building, method::kSwarmMembers)};
      if (!swarm.members.empty()) swarms.push_back(std::move(swarm));
    }
    return swarms;
  }
  SharedList<StampedPose> trajectory() const override {
    return SharedListWriter<StampedPose>(slam_.best().path.poses()).share();
  }
  std::function<Map()> refinedMap() const override {
    return [drawing = drawing_, map = slam_.refinedMap(), rays = wall_rays_] {
      Map stated = map;
      rays.state(*drawing, stated);
      return stated;
    };
  }

 private:
  std::shared_ptr<const Map> drawing_;
  FastSlamPsom slam_;
  WallRays wall_rays_;
  Recognition recognition_{Recognition::Drawing::FromMemory};
  PhaseRecorder* recorder_ = nullptr;
};

}  // namespace

std::unique_ptr<EstimationMethod> makePaperMethod(const Map& drawing, const SourceInfo& source,
                                                  const RunSettings& settings) {
  return std::make_unique<PaperMethod>(drawing, source, settings);
}

}  // namespace handmap
