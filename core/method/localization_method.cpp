#include "core/method/localization_method.h"

#include "core/base/random.h"
#include "core/estimation/samples.h"
#include "core/map_match/matched_trajectory.h"
#include "core/method/recognition.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {

namespace {

class LocalizationMethod : public EstimationMethod {
 public:
  LocalizationMethod(const Map& map, const SourceInfo& source, const RunSettings& settings)
      : map_(std::make_shared<const Map>(checked(map))),
        start_odometry_(source.start_odometry),
        particles_(settings.slam.slam_particles),
        seed_(settings.seed),
        seen_(source.range_limit_m),
        trajectory_({.range_limit_m = source.range_limit_m}),
        matched_(*map_, seen_),
        outlines_(outlinesOf(*map_)) {
    for (PlacedOutline& outline : outlines_) outline.found = true;
  }

  bool step(double time_s, const Odometry& odometry, const Percept& percept,
            const LazyLocalMap& /*local_map*/, const std::stop_token& stop,
            const std::function<void(double)>& /*progress*/) override {
    if (stop.stop_requested()) return false;
    if (times_.empty()) add(0.0, start_odometry_, {}, stop);
    add(time_s, odometry, percept, stop);
    return true;
  }

  bool finish(const std::stop_token& stop, const std::function<void(double)>&) override {
    matched_.finish(stop);
    return true;
  }

  void describe(FrameReport& report) const override {
    report.effective_sample_size = particles_;
    report.visible_buildings = matched_.visibleBuildings();
    report.pose = matched_.pose();
    recognition_.state(matched_.covariance(), report);
  }
  std::vector<ParticleView> particles() const override {
    const PoseSampler sample(matched_.pose(), matched_.covariance());
    std::vector<ParticleView> views;
    for (int i = 0; i < particles_; ++i) {
      RandomStream random(seed_, static_cast<std::uint32_t>(times_.size()),
                          static_cast<std::uint32_t>(i), 0);
      views.push_back({sample(random), 1.0 / particles_});
    }
    return views;
  }
  std::vector<BuildingSwarm> swarms() const override { return {}; }
  /// Without the place of the start, where nothing was observed.
  SharedList<StampedPose> trajectory() const override {
    const std::vector<Pose2> poses = matched_.poses();
    SharedListWriter<StampedPose> trajectory;
    for (std::size_t i = 1; i < poses.size(); ++i) trajectory.push_back({times_[i], poses[i]});
    return trajectory.share();
  }
  std::function<Map()> refinedMap() const override {
    return [map = map_] { return *map; };
  }

 private:
  static const Map& checked(const Map& map) {
    requireReadyToRun(map);
    return map;
  }
  void add(double time_s, const Odometry& odometry, const Percept& percept,
           const std::stop_token& stop) {
    const Pose2 before = times_.empty() ? odometry.pose : trajectory_.recorded().back();
    trajectory_.add(time_s, odometry, percept, stop);
    if (!times_.empty()) seen_.add(times_.size(), odometry.pose, percept.scan, percept.points);
    times_.push_back(time_s);
    matched_.add(trajectory_.poses(), trajectory_.usable() ? kMatchedScans : kWheels,
                 odometry.guessed);
    recognition_.look(wall_rays_.add(outlines_, matched_.pose(), percept.scan),
                      between(before, odometry.pose).position().norm(), odometry.guessed);
  }

  std::shared_ptr<const Map> map_;
  Pose2 start_odometry_;
  int particles_;
  std::uint64_t seed_;
  std::vector<double> times_;  ///< the start's, then of the observations
  SeenFrames seen_;
  ScanTrajectory trajectory_;
  MatchedTrajectory matched_;
  std::vector<PlacedOutline>
      outlines_;  ///< all taken for found: the map is right, or it is not this one
  WallRays wall_rays_;
  Recognition recognition_{Recognition::Drawing::True};
};

}  // namespace

std::unique_ptr<EstimationMethod> makeLocalizationMethod(const Map& map, const SourceInfo& source,
                                                         const RunSettings& settings) {
  return std::make_unique<LocalizationMethod>(map, source, settings);
}

}  // namespace handmap
