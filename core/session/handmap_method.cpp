#include "core/session/handmap_method.h"

#include <algorithm>

#include "core/anchoring/anchored_way.h"
#include "core/estimation/estimator.h"
#include "core/outlines/refinement.h"
#include "core/session/pose_trust.h"
#include "core/session/wheel_uncertainty.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {

namespace {

EstimatorOptions estimatorOptions(const SourceInfo& source, const RunSettings& settings) {
  EstimatorOptions options;
  options.range_limit_m = source.range_limit_m;
  options.particles = settings.slam.slam_particles;
  options.assignment.free_scale = settings.free_scale;
  options.assignment.free_turn = settings.free_turn;
  return options;
}

/// What a map's frame and a start are off at best: as much as the reference poses of real places.
constexpr double kReference_m = 0.3;

/// A way of the robot that is thought of: poses of all observations, map frame.
struct Way {
  enum class By { Buildings, Odometry, Scans, Walls };
  By by;
  std::vector<Pose2> poses;
};

class HandmapMethod : public EstimationMethod {
 public:
  HandmapMethod(const Map& drawing, const SourceInfo& source, const RunSettings& settings)
      : drawing_(drawing),
        start_(*drawing.start * inverse(source.start_odometry)),
        seed_(settings.seed),
        seen_(source.range_limit_m),
        trajectory_({.range_limit_m = source.range_limit_m}),
        estimator_(drawing, estimatorOptions(source, settings), settings.seed) {
    estimator_.startFrom(source.start_odometry);
  }

  bool step(double time_s, const Pose2& odometry, const Percept& percept,
            const std::stop_token& stop, const std::function<void(double)>& progress) override {
    if (stop.stop_requested()) return false;
    if (observations_ == 0) anchor(odometry);
    trajectory_.add(time_s, odometry, percept.points, stop);
    wheels_.add(odometry);
    followTrajectory();
    const Pose2& here = trajectory_.poses().back();
    estimator_.step(time_s, here, percept.scan, stop, progress);
    seen_.add(observations_++, odometry, percept.scan, percept.points);
    if (anchored_) {
      anchored_->add(trajectory_.poses(), by_scans_ ? WayNoise::Scans : WayNoise::Recorded);
    }
    return true;
  }

  bool finish(const std::stop_token& stop, const std::function<void(double)>& progress) override {
    estimator_.finish(stop);
    if (anchored_) anchored_->finish(stop);
    if (stop.stop_requested()) return true;
    Way way = chosenWay();
    const Map found_map = estimator_.refinedMap();
    std::optional<FoundMap> found;
    if (way.by == Way::By::Buildings) found.emplace(found_map, estimator_.drawingMotion());
    refined_ = refine(drawing_, found, seen_, way.poses, seed_, stop, progress);
    if (refined_) way_ = std::move(way);
    return true;
  }

  void describe(FrameReport& report) const override {
    report.effective_sample_size = estimator_.effectiveSampleSize();
    report.visible_buildings = estimator_.visibleBuildings();
    report.pose = way_ ? way_->poses.back() : estimator_.pose();
    stateTrust(poseCovariance(), report);
  }
  std::vector<ParticleView> particles() const override {
    std::vector<ParticleView> views;
    for (const PoseParticle& particle : estimator_.particles()) {
      views.push_back({particle.pose, particle.weight});
    }
    return views;
  }
  std::vector<BuildingSwarm> swarms() const override { return estimator_.swarms(kSwarmMembers); }
  SharedList<StampedPose> trajectory() const override {
    if (!way_) return estimator_.trajectory();
    std::vector<StampedPose> poses = estimator_.trajectory().all();
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].pose = way_->poses[i];
    return SharedListWriter<StampedPose>(poses).share();
  }
  std::function<Map()> refinedMap() const override {
    if (!refined_) return estimator_.refinedMapLater();
    return [map = *refined_] { return map; };
  }

 private:
  /// A drawing that says that it is true as a whole, and nearly so in its parts, is one to lay the
  /// way on.
  void anchor(const Pose2& odometry) {
    constexpr double kNearlyTrue_m = 1.0;
    const auto& [scale, turn] = drawing_.whole;
    if (!scale || *scale > 0.0 || !turn || *turn > 0.0) return;
    if (drawing_.uncertainty.position > kNearlyTrue_m) return;
    Map from_here = drawing_;
    from_here.start = start_ * odometry;
    anchored_.emplace(from_here, seen_);
  }

  /// Where matched scans tell the way the buildings are found along that, and laid anew with it
  /// where a loop was closed.
  void followTrajectory() {
    const bool changed = trajectory_.usable() != by_scans_ || trajectory_.loops() != loops_;
    if (!changed) return;
    by_scans_ = trajectory_.usable();
    loops_ = trajectory_.loops();
    std::vector<Pose2> before = trajectory_.poses();
    before.pop_back();  // the newest is not with the estimator yet
    estimator_.reviseOdometry(before, trajectory_.noiseScale());
  }

  /// The odometry, matched scans, the walls of a drawing that is true and the buildings each tell a
  /// way. Those of walls and buildings are dropped where they make what was seen less sharp.
  Way chosenWay() const {
    constexpr double kMargin = 0.015;  // of sharpness: less is chance
    const bool scans = trajectory_.usable();
    Way alone{scans ? Way::By::Scans : Way::By::Odometry, {}};
    for (const Pose2& pose : scans ? trajectory_.poses() : trajectory_.recorded()) {
      alone.poses.push_back(start_ * pose);
    }
    Way buildings{Way::By::Buildings, {}};
    for (const StampedPose& pose : estimator_.trajectory().all()) {
      buildings.poses.push_back(pose.pose);
    }
    const double needed = trajectory_.sharpness(alone.poses) - kMargin;
    if (anchored_) {
      Way walls{Way::By::Walls, anchored_->poses()};
      if (trajectory_.sharpness(walls.poses) >= needed) return walls;
    }
    return trajectory_.sharpness(buildings.poses) < needed ? alone : buildings;
  }

  /// Of the stated pose. A way without the buildings was told by one thing alone: where the
  /// buildings would have had the robot farther away than either says, it is as much less sure.
  Eigen::Matrix3d poseCovariance() const {
    const Eigen::Matrix3d& buildings = estimator_.poseCovariance();
    Eigen::Matrix3d covariance = buildings;
    if (way_ && way_->by == Way::By::Walls) {
      covariance = anchored_->covariance();
    } else if (way_ && way_->by != Way::By::Buildings) {
      const Eigen::Matrix3d turn = rotation(start_.heading);
      const bool scans = way_->by == Way::By::Scans;
      covariance =
          turn * (scans ? trajectory_.covariance() : wheels_.covariance()) * turn.transpose();
      const Vec2 apart = way_->poses.back().position() - estimator_.pose().position();
      const double stated = (covariance + buildings).topLeftCorner<2, 2>().trace();
      if (stated > 0.0) covariance *= std::max(1.0, apart.squaredNorm() / stated);
    }
    covariance.diagonal().head<2>().array() += kReference_m * kReference_m;
    return covariance;
  }

  Map drawing_;
  Pose2 start_;  ///< of the odometry frame, map frame
  std::uint64_t seed_;
  SeenFrames seen_;
  std::size_t observations_ = 0;
  ScanTrajectory trajectory_;
  WheelUncertainty wheels_;
  bool by_scans_ = false;
  int loops_ = 0;
  HandmapEstimator estimator_;
  std::optional<AnchoredWay> anchored_;
  std::optional<Way> way_;      ///< after the end of the run, and
  std::optional<Map> refined_;  ///< the drawing on it
};

}  // namespace

std::unique_ptr<EstimationMethod> makeHandmapMethod(const Map& drawing, const SourceInfo& source,
                                                    const RunSettings& settings) {
  return std::make_unique<HandmapMethod>(drawing, source, settings);
}

}  // namespace handmap
