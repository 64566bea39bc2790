#include "core/method/handmap_method.h"

#include <algorithm>
#include <cmath>

#include "core/base/phrase.h"
#include "core/estimation/buildings/constants.h"
#include "core/estimation/estimator.h"
#include "core/explain/seen_walls.h"
#include "core/geometry/pose_covariance.h"
#include "core/map/certainty.h"
#include "core/map_match/matched_trajectory.h"
#include "core/method/conclusions.h"
#include "core/method/constants.h"
#include "core/method/doubt.h"
#include "core/method/handmap_phases.h"
#include "core/method/pose_trust.h"
#include "core/method/recognition.h"
#include "core/method/wheel_uncertainty.h"
#include "core/trajectory/scan_trajectory.h"

namespace handmap {

using namespace method;

namespace {

EstimatorOptions estimatorOptions(const SourceInfo& source, const RunSettings& settings) {
  EstimatorOptions options;
  options.range_limit_m = source.range_limit_m;
  options.particles = settings.slam.slam_particles;
  options.assignment.free_scale = settings.free_scale;
  options.assignment.free_turn = settings.free_turn;
  return options;
}

class HandmapMethod : public EstimationMethod {
 public:
  HandmapMethod(const Map& drawing, const SourceInfo& source, const RunSettings& settings)
      : drawing_(drawing),
        shared_drawing_(std::make_shared<const Map>(drawing)),
        start_(*drawing.start * inverse(source.start_odometry)),
        seed_(settings.seed),
        on_the_way_(settings.conclude_on_the_way),
        seen_(source.range_limit_m),
        trajectory_({.range_limit_m = source.range_limit_m}),
        estimator_(drawing, estimatorOptions(source, settings), settings.seed) {
    estimator_.startFrom(source.start_odometry);
  }

  /// The page of README.md, a line a step.
  bool step(double time_s, const Odometry& odometry, const Percept& percept,
            const LazyLocalMap& /*local_map*/, const std::stop_token& stop,
            const std::function<void(double)>& progress) override {
    if (stop.stop_requested()) return false;
    if (auto conclusion = conclusions_.take()) show(std::move(*conclusion));
    if (observations_ == 0) matchToWalls(odometry.pose);
    drive(time_s, odometry, percept, stop);
    findBuildings(time_s, odometry.guessed, percept, stop, progress);
    if (keep(odometry.pose, percept)) look(percept.scan, odometry.guessed);
    if (matched_) {
      matched_->add(trajectory_.poses(), by_scans_ ? kMatchedScans : kWheels, odometry.guessed);
    }
    goOn(time_s);
    if (on_the_way_) conclusions_.begin(driven_m_, [this] { return concluding(); });
    return true;
  }

  void trace(PhaseRecorder* recorder) override { recorder_ = recorder; }

  bool finish(const std::stop_token& stop, const std::function<void(double)>& progress) override {
    conclusions_.end();
    estimator_.finish(stop);
    if (matched_) matched_->finish(stop);
    auto last = conclude(drawing_, known(), seed_, stop, progress);
    if (!last) return true;
    show(std::move(*last));
    finished_ = true;
    return true;
  }

  std::vector<RunWarning> warnings() const override {
    std::vector<RunWarning> warnings;
    if (!conclusions_.trouble().empty()) {
      warnings.push_back({"conclusion_failed",
                          phrase("The correction on the way failed: {}", conclusions_.trouble()),
                          phrase("The end of the run does not depend on it.")});
    }
    if (concluded_ && concluded_->unfounded) {
      warnings.push_back(
          {"buildings_dropped",
           phrase("Some drawn buildings were found on the way, but few walls stand where they "
                  "would be: they were dropped."),
           phrase("Drive closer to the buildings, or with a sensor that sees more of their "
                  "walls.")});
    }
    if (concluded_ && concluded_->start_off) {
      const Pose2& off = *concluded_->start_off;
      warnings.push_back(
          {"start_refuted",
           phrase("The drawn buildings together say that the run began {:.1f} m and {:.0f}° off "
                  "the drawn start: they were believed.",
                  off.position().norm(), std::abs(toDegrees(off.heading))),
           phrase("Correct the start, or state how sure it is.")});
    }
    return warnings;
  }

  void describe(FrameReport& report) const override {
    report.effective_sample_size = estimator_.effectiveSampleSize();
    report.visible_buildings = estimator_.visibleBuildings();
    report.log_likelihood = estimator_.logLikelihood();
    report.loops = trajectory_.loops();
    report.pose = pose();
    recognition_.state(poseCovariance(), report);
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
    return showsEstimator() ? estimator_.trajectory() : shown_trajectory_;
  }
  std::function<Map()> refinedMap() const override {
    const bool goes_on = !concluded_ || (!finished_ && concluded_->trajectory.by ==
                                                           TrajectoryHypothesis::By::Buildings);
    const bool laid = concluded_ && concluded_->covariance;  // on a drawing that is right
    return [drawing = shared_drawing_, concluded = concluded_map_, laid,
            since = goes_on ? estimatedMap() : std::function<Map()>()] {
      Map now = since ? since() : *concluded;
      for (std::size_t b = 0; since && concluded && b < concluded->buildings.size(); ++b) {
        const Building& last = concluded->buildings[b];
        if (isRecognised(last) &&
            (laid || isBetterFounded(last, now.buildings[b], drawing->buildings[b])))
          now.buildings[b] = last;
      }
      stateDoubt(*drawing, now);
      return now;
    };
  }

 private:
  /// The way without the drawing.
  void drive(double time_s, const Odometry& odometry, const Percept& percept,
             const std::stop_token& stop) {
    const Pose2 before = observations_ == 0 ? odometry.pose : trajectory_.recorded().back();
    driven_m_ += between(before, odometry.pose).position().norm();
    trajectory_.add(time_s, odometry, percept, stop);
    wheels_.add(odometry);
    followTrajectory();
  }

  /// Along that way, and what they make of it.
  void findBuildings(double time_s, const Eigen::Matrix3d& guessed, const Percept& percept,
                     const std::stop_token& stop, const std::function<void(double)>& progress) {
    if (recorder_ != nullptr) {
      estimator_.watch(HandmapPhases(estimator_, drawing_, *recorder_, *this));
    }
    estimator_.step(time_s, {trajectory_.poses().back(), guessed}, percept.scan, stop, progress);
    estimator_.watch({});
  }

  /// For the outlines; whether it was worth it.
  bool keep(const Pose2& odometry, const Percept& percept) {
    const std::size_t before = seen_.frames().size();
    seen_.add(observations_++, odometry, percept.scan, percept.points);
    return seen_.frames().size() > before;
  }

  /// The believed way, as what tells it tells on.
  void goOn(double time_s) {
    if (showsEstimator()) return;
    shown_writer_.push_back({time_s, pose()});
    shown_trajectory_ = shown_writer_.share();
  }

  /// What tells the way that is shown: until something is concluded the buildings, unless it was
  /// followed in images or points.
  TrajectoryHypothesis::By shownBy() const {
    if (concluded_) return concluded_->trajectory.by;
    return followed_ ? TrajectoryHypothesis::By::Scans : TrajectoryHypothesis::By::Buildings;
  }
  bool showsEstimator() const { return !concluded_ && !followed_; }

  /// Which walls rays end on. What points lie on that were followed nobody knows: that few of them
  /// are on walls says nothing of where the robot is.
  void look(const Scan& scan, const Eigen::Matrix3d& guessed) {
    std::vector<PlacedOutline> placed;
    for (NearbyBuilding& building : estimator_.nearby())
      placed.push_back({building.building, std::move(building.outline), building.found});
    const WallRays::Share share = wall_rays_.add(placed, estimator_.pose(), scan);
    if (!trajectory_.hasTracks()) recognition_.look(share, driven_m_ - looked_at_m_, guessed);
    shown_rays_ = std::make_shared<const WallRays>(wall_rays_);
    looked_at_m_ = driven_m_;
  }

  /// The drawing as the estimator has it now. What was found by less than a wall is shown where
  /// the drawing has it: its outline would be another one with each look.
  std::function<Map()> estimatedMap() const {
    return [drawing = shared_drawing_, later = estimator_.refinedMapLater(),
            predicted_later = estimator_.predictedMapLater(), rays = shown_rays_] {
      Map map = later();
      rays->state(*drawing, map);
      Map predicted = predicted_later();
      for (std::size_t b = 0; b < map.buildings.size(); ++b) {
        if (!drawing->buildings[b].fixed && !hasSeenWall(map.buildings[b]))
          map.buildings[b] = std::move(predicted.buildings[b]);
      }
      return map;
    };
  }

  /// A drawing that says that it is true as a whole, and nearly so in its parts, is one to lay the
  /// way on.
  void matchToWalls(const Pose2& odometry) {
    const WholeUncertainty& whole = drawing_.whole;
    if (!whole.scale || *whole.scale > 0.0 || !whole.turn || *whole.turn > 0.0) return;
    if (std::max(drawing_.uncertainty.position, drawing_.shiftSigma()) > kNearlyTrue_m) return;
    Map from_here = drawing_;
    from_here.start = start_ * odometry;
    matched_.emplace(from_here, seen_);
  }

  /// Where matched scans tell the way the buildings are found along that, and laid anew with it
  /// where a loop was closed. A way that was followed is shown until there is a conclusion.
  void followTrajectory() {
    const bool loop_closed = trajectory_.loops() != loops_;
    const bool followed = trajectory_.isFollowed() && !matched_;
    if (followed && !concluded_ && (!followed_ || loop_closed)) {
      std::vector<Pose2> before = posesBy(TrajectoryHypothesis::By::Scans);
      before.pop_back();  // the newest goes on from them
      showAlong(before);
    }
    followed_ = followed;
    if (trajectory_.usable() == by_scans_ && !loop_closed) return;
    by_scans_ = trajectory_.usable();
    loops_ = trajectory_.loops();
    std::vector<Pose2> before = trajectory_.poses();
    before.pop_back();  // the newest is not with the estimator yet
    estimator_.reviseOdometry(before, trajectory_.noiseScale());
  }

  /// All poses as one source tells them, as it told them first in the map frame.
  std::vector<Pose2> posesBy(TrajectoryHypothesis::By by) const {
    std::vector<Pose2> poses;
    if (by == TrajectoryHypothesis::By::Walls) return matched_->poses();
    if (by == TrajectoryHypothesis::By::Buildings) {
      for (const StampedPose& pose : estimator_.trajectory().all()) poses.push_back(pose.pose);
      return poses;
    }
    const bool scans = by == TrajectoryHypothesis::By::Scans;
    for (const Pose2& pose : scans ? trajectory_.scanPoses() : trajectory_.recorded()) {
      poses.push_back(start_ * pose);
    }
    return poses;
  }
  Pose2 newestBy(TrajectoryHypothesis::By by) const {
    switch (by) {
      case TrajectoryHypothesis::By::Walls:
        return matched_->pose();
      case TrajectoryHypothesis::By::Scans:
        return start_ * trajectory_.scanPoses().back();
      case TrajectoryHypothesis::By::Odometry:
        return start_ * trajectory_.recorded().back();
      case TrajectoryHypothesis::By::Buildings:
        break;
    }
    return estimator_.pose();
  }
  Pose2 pose() const { return onward_ * newestBy(shownBy()); }

  /// A heading that strays evenly swings what is far by 1 / √3 of what it is off there.
  double turnOf(TrajectoryHypothesis::By alone) const {
    return alone == TrajectoryHypothesis::By::Scans
               ? trajectory_.turn()
               : std::sqrt(std::max(0.0, wheels_.covariance()(2, 2)) / 3.0);
  }

  RunKnowledge known() const {
    const TrajectoryHypothesis::By alone =
        trajectory_.usable() ? TrajectoryHypothesis::By::Scans : TrajectoryHypothesis::By::Odometry;
    std::optional<TrajectoryHypothesis> walls;
    if (matched_)
      walls = TrajectoryHypothesis{TrajectoryHypothesis::By::Walls,
                                   posesBy(TrajectoryHypothesis::By::Walls)};
    return {{alone, posesBy(alone), turnOf(alone), trajectory_.isFollowed()},
            {TrajectoryHypothesis::By::Buildings, posesBy(TrajectoryHypothesis::By::Buildings)},
            std::move(walls),
            estimator_.refinedMap(),
            estimator_.predictedMapLater(),
            estimator_.drawingMotion(),
            seen_,
            trajectory_.sharpnessLater()};
  }

  Conclusions::Make concluding() const {
    return [drawing = drawing_, seed = seed_, known = known()](const std::stop_token& stop) {
      return conclude(drawing, known, seed, stop);
    };
  }

  /// From now on the way is the believed one, and goes on as that does.
  void show(Conclusion conclusion) {
    concluded_ = std::move(conclusion);
    concluded_map_ = std::make_shared<const Map>(std::move(concluded_->map));
    std::vector<Pose2>& poses = concluded_->trajectory.poses;
    const std::vector<Pose2> told = posesBy(concluded_->trajectory.by);
    onward_ = poses.back() * inverse(told[poses.size() - 1]);
    for (std::size_t i = poses.size(); i < told.size(); ++i) poses.push_back(onward_ * told[i]);
    showAlong(poses);
  }

  void showAlong(const std::vector<Pose2>& poses) {
    shown_writer_ = {};
    for (std::size_t i = 0; i < poses.size(); ++i) {
      shown_writer_.push_back({estimator_.trajectory()[i].time_s, poses[i]});
    }
    shown_trajectory_ = shown_writer_.share();
  }

  /// Of the stated pose. A way without the buildings was told by one thing alone: where the
  /// buildings would have had the robot farther away than either says, it is as much less sure,
  /// unless it was followed: no drawing tells that better.
  Eigen::Matrix3d poseCovariance() const {
    const Eigen::Matrix3d& buildings = estimator_.poseCovariance();
    Eigen::Matrix3d covariance = buildings;
    const TrajectoryHypothesis::By by = shownBy();
    if (concluded_ && concluded_->covariance) {
      covariance = *concluded_->covariance;
    } else if (by == TrajectoryHypothesis::By::Walls) {
      covariance = matched_->covariance();
    } else if (by != TrajectoryHypothesis::By::Buildings) {
      const bool scans = by == TrajectoryHypothesis::By::Scans;
      covariance =
          turnedBy(start_.heading, scans ? trajectory_.covariance() : wheels_.covariance());
      const Vec2 apart = pose().position() - estimator_.pose().position();
      const double stated = (covariance + buildings).topLeftCorner<2, 2>().trace();
      if (stated > 0.0 && !(scans && followed_))
        covariance *= std::max(1.0, apart.squaredNorm() / stated);
    }
    covariance.diagonal().head<2>().array() += buildings::kFloor_m * buildings::kFloor_m;
    const bool laid =
        by == TrajectoryHypothesis::By::Walls || (concluded_ && concluded_->covariance);
    // What the start is off turns and shifts the whole way.
    const Vec2 from_start = pose().position() - drawing_.start->position();
    const auto add_start = [&](double position_m, double heading) {
      const Eigen::Vector3d sigma(position_m, position_m, heading);
      covariance += swungBy(from_start, sigma.cwiseAbs2().asDiagonal());
    };
    const bool by_matches =
        by_scans_ && (!followed_ || trajectory_.hasTracks());  // that err together
    if (by_matches && !laid)
      add_start(0.0, concluded_ ? concluded_->trajectory.turn : trajectory_.turn());
    if (concluded_ && concluded_->start_variance) {
      covariance += swungBy(from_start, *concluded_->start_variance);
    } else if (const auto& start = drawing_.start_uncertainty) {
      // The walls are corrected from where the robot is: they are off with it.
      add_start(start->position, start->heading);
    }
    return covariance;
  }

  Map drawing_;
  std::shared_ptr<const Map> shared_drawing_;  ///< the same, for what is made later
  Pose2 start_;                                ///< of the odometry frame, map frame
  std::uint64_t seed_;
  bool on_the_way_;
  SeenFrames seen_;
  std::size_t observations_ = 0;
  ScanTrajectory trajectory_;
  WheelUncertainty wheels_;
  bool by_scans_ = false;
  bool followed_ = false;  ///< it was, in images or points
  int loops_ = 0;
  HandmapEstimator estimator_;
  Recognition recognition_{Recognition::Drawing::FromMemory};
  double looked_at_m_ = 0.0;  ///< driven by then
  WallRays wall_rays_;        ///< of the buildings as the estimator had them when they were met
  std::shared_ptr<const WallRays> shown_rays_ = std::make_shared<const WallRays>();  ///< the same
  PhaseRecorder* recorder_ = nullptr;
  std::optional<MatchedTrajectory> matched_;
  double driven_m_ = 0.0;  ///< by the recorded odometry
  Conclusions conclusions_;
  std::optional<Conclusion> concluded_;       ///< the newest, but for its map
  std::shared_ptr<const Map> concluded_map_;  ///< shared by all that is shown of it
  Pose2 onward_;  ///< from what tells its way to where that lies on the map
  SharedListWriter<StampedPose> shown_writer_;
  SharedList<StampedPose> shown_trajectory_;  ///< the believed way, where it is not the estimator's
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<EstimationMethod> makeHandmapMethod(const Map& drawing, const SourceInfo& source,
                                                    const RunSettings& settings) {
  return std::make_unique<HandmapMethod>(drawing, source, settings);
}

}  // namespace handmap
