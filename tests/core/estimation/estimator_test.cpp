#include "core/estimation/estimator.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/evaluation/comparison.h"
#include "core/map/map_io.h"
#include "core/perception/perception.h"
#include "core/simulation/simulated_source.h"

namespace handmap {
namespace {

struct Outcome {
  Map refined;
  std::vector<StampedPose> trajectory;
  double pose_error = 0.0;
  double odometry_error = 0.0;
};

Outcome runThrough(const World& world, const Map& drawing, int observations,
                   const SimulationOptions& options = {}) {
  const auto source = simulate(world, options, 5);
  HandmapEstimator estimator(drawing, EstimatorOptions{}, 1);
  Perception perception(source->info(), {});
  Outcome run;
  Pose2 odometry;
  for (int i = 0; i < observations; ++i) {
    const auto observation = source->next();
    if (!observation) break;
    odometry = observation->odometry;
    estimator.step(observation->time_s, odometry, perception(*observation)->scan);
  }
  estimator.finish();
  run.refined = estimator.refinedMap();
  run.trajectory = estimator.trajectory().all();
  const Pose2 truth = source->info().truth[run.trajectory.size() - 1].pose;
  run.pose_error = (estimator.pose().position() - truth.position()).norm();
  run.odometry_error = ((*drawing.start * odometry).position() - truth.position()).norm();
  return run;
}

TEST(HandmapEstimator, FindsEveryBuildingOfTwoRows) {
  const World world = twoRowWorld(17);
  const Map drawing = perturbed(world.map, 10.0, 18);
  const Outcome run = runThrough(world, drawing, 1000);
  for (const BuildingError& error : compareMaps(run.refined, world.map, false).buildings) {
    EXPECT_GT(error.iou, 0.8) << error.id;
  }
  EXPECT_LT(run.pose_error, 1.5);
  for (const Building& building : run.refined.buildings) {
    ASSERT_TRUE(building.estimate.has_value());
    EXPECT_GT(building.estimate->observations, 3) << building.id;
    EXPECT_LT(building.estimate->sigma_width, 2.0) << building.id;
  }
}

/// Drawn over an aerial picture: the corners of the true boxes are off by some decimetres.
Map tracedFromTheAir(const Map& truth, std::uint64_t seed) {
  RandomStream random(seed);
  Map drawing = truth;
  for (Building& building : drawing.buildings) {
    Rectangle box = building.box();
    box.centre += Vec2(random.normal(0.0, 0.2), random.normal(0.0, 0.2));
    box.width += random.normal(0.0, 0.2);
    box.depth += random.normal(0.0, 0.2);
    building.shape = box;
  }
  drawing.uncertainty = {0.3, 0.3};
  drawing.whole = {0.0, 0.0};
  return drawing;
}

/// The sensor measures all ranges and the wheels all ways 3 % too long.
class StretchedSource : public ObservationSource {
 public:
  explicit StretchedSource(std::unique_ptr<ObservationSource> source)
      : source_(std::move(source)) {}
  const SourceInfo& info() const override { return source_->info(); }
  std::optional<Observation> next() override {
    std::optional<Observation> observation = source_->next();
    if (!observation) return observation;
    observation->odometry.x *= kStretch;
    observation->odometry.y *= kStretch;
    for (View& view : observation->views) {
      for (RangePoint& point : *view.points) {
        point.x *= static_cast<float>(kStretch);
        point.y *= static_cast<float>(kStretch);
      }
    }
    return observation;
  }

 private:
  static constexpr double kStretch = 1.03;
  std::unique_ptr<ObservationSource> source_;
};

double scaleAfter(const Map& drawing, const World& world) {
  StretchedSource source(simulate(world, {}, 5));
  HandmapEstimator estimator(drawing, EstimatorOptions{}, 1);
  Perception perception(source.info(), {});
  while (const auto observation = source.next()) {
    estimator.step(observation->time_s, observation->odometry, perception(*observation)->scan);
  }
  estimator.finish();
  return estimator.drawingMotion().scale();
}

TEST(HandmapEstimator, ADrawingOverAnAerialPictureKeepsItsScaleAndTurn) {
  const World world = twoRowWorld(17);
  Map drawing = tracedFromTheAir(world.map, 3);
  const Outcome run = runThrough(world, drawing, 1000);
  for (const BuildingError& error : compareMaps(run.refined, world.map, false).buildings) {
    EXPECT_GT(error.iou, 0.9) << error.id;
  }
  EXPECT_NEAR(scaleAfter(drawing, world), 1.0, 1e-3);
  drawing.whole = {};  // as people draw: what is seen tells the scale
  EXPECT_GT(scaleAfter(drawing, world), 1.01);
}

TEST(HandmapEstimator, ClosesALoop) {
  const World world = loopWorld(4);
  SimulationOptions half;
  half.view_rad = kPi;
  const Outcome run = runThrough(world, perturbed(world.map, 4.0, 5), 1000, half);
  EXPECT_GT(run.odometry_error, 5.0);
  EXPECT_LT(run.pose_error, 1.0);
  double iou = 0.0;
  const auto errors = compareMaps(run.refined, world.map, false).buildings;
  for (const BuildingError& error : errors) iou += error.iou;
  EXPECT_GT(iou / static_cast<double>(errors.size()), 0.7);
}

TEST(HandmapEstimator, WhereNothingIsSeenThePoseIsAsUnsureAsTheWheels) {
  const World world = twoRowWorld(17);
  const auto source = simulate(world, {}, 5);
  HandmapEstimator estimator(world.map, EstimatorOptions{}, 1);
  Perception perception(source->info(), {});
  std::vector<Pose2> odometry;
  const int seen = source->info().observations / 2;
  while (const auto observation = source->next()) {
    const bool blind = static_cast<int>(odometry.size()) >= seen;
    odometry.push_back(observation->odometry);
    estimator.step(observation->time_s, odometry.back(),
                   blind ? Scan{} : perception(*observation)->scan);
    if (static_cast<int>(odometry.size()) == seen) estimator.reviseOdometry(odometry, 0.1);
  }
  estimator.finish();
  const double way_m =
      (odometry.back().position() - odometry[static_cast<std::size_t>(seen)].position()).norm();
  ASSERT_GT(way_m, 30.0);
  const double by_wheels = kWheels.heading_variance_per_m * way_m;
  EXPECT_GT(estimator.poseCovariance()(2, 2), 0.4 * by_wheels);
}

TEST(HandmapEstimator, IsTheSameEveryTime) {
  const World world = twoRowWorld(19);
  const Map drawing = perturbed(world.map, 5.0, 20);
  EXPECT_EQ(formatMap(runThrough(world, drawing, 12).refined),
            formatMap(runThrough(world, drawing, 12).refined));
}

TEST(HandmapEstimator, TakesPolygonsAndAnyHeading) {
  const World world = campusWorld(3);
  const Map drawing = perturbed(world.map, 3.0, 4);
  const Outcome run = runThrough(world, drawing, 1000);
  ASSERT_EQ(run.refined.buildings.size(), drawing.buildings.size());
  double sum = 0.0;
  const auto errors = compareMaps(run.refined, world.map, false).buildings;
  for (const BuildingError& error : errors) sum += error.iou;
  EXPECT_GT(sum / static_cast<double>(errors.size()), 0.8);
  for (const Building& building : run.refined.buildings) {
    EXPECT_TRUE(isSimple(building.footprint())) << building.id;
    EXPECT_TRUE(building.box().centre.allFinite());
  }
}

TEST(HandmapEstimator, AnObservationIsWorkedInWholeWhenAStopIsRequested) {
  const World world = twoRowWorld(21);
  HandmapEstimator estimator(world.map, EstimatorOptions{}, 1);
  std::stop_source stop;
  stop.request_stop();
  estimator.step(0.0, Pose2{}, Scan{}, stop.get_token());
  EXPECT_EQ(estimator.trajectory().size(), 1U);
}

TEST(HandmapEstimator, ObservationsBetweenKeyFramesDoAPartOfTheWork) {
  using enum EstimatorPhase;
  HandmapEstimator estimator(twoRowWorld(21).map, EstimatorOptions{}, 1);
  std::vector<EstimatorPhase> reached;
  estimator.watch([&](EstimatorPhase phase) { reached.push_back(phase); });
  const auto phases_at = [&](double x) {
    reached.clear();
    estimator.step(x, Pose2{x, 0.0, 0.0}, Scan{});
    EXPECT_NEAR(
        (estimator.pose().position() - estimator.trajectory().back().pose.position()).norm(), 0.0,
        1e-9);
    return reached;
  };
  using Phases = std::vector<EstimatorPhase>;
  EXPECT_EQ(phases_at(0.0), (Phases{Way, Poses, Evidence, Detection, Labels, Correction}));
  EXPECT_EQ(phases_at(1.5), Phases{Way});
  EXPECT_EQ(phases_at(3.0), (Phases{Way, Poses, Evidence}));
  EXPECT_EQ(phases_at(4.0), (Phases{Way, Detection, Labels}));
  EXPECT_EQ(phases_at(4.5), (Phases{Way, Correction}));
  EXPECT_EQ(phases_at(5.5), (Phases{Way, Poses, Evidence}));
  EXPECT_EQ(phases_at(7.5), (Phases{Detection, Labels, Correction, Way, Poses, Evidence, Detection,
                                    Labels, Correction}));
}

TEST(HandmapEstimator, ParticlesSpreadAroundThePose) {
  const World world = twoRowWorld(22);
  HandmapEstimator estimator(world.map, EstimatorOptions{}, 1);
  estimator.step(0.0, Pose2{}, Scan{});
  estimator.step(1.0, Pose2{5.0, 0.0, 0.0}, Scan{});
  double weight = 0.0;
  for (const PoseParticle& particle : estimator.particles()) {
    weight += particle.weight;
    EXPECT_LT((particle.pose.position() - estimator.pose().position()).norm(), 2.0);
  }
  EXPECT_NEAR(weight, 1.0, 1e-9);
  EXPECT_GE(estimator.effectiveSampleSize(), 1.0);
}

TEST(HandmapEstimator, SwarmsLieAroundTheBuildingsAsTheEstimateSays) {
  const World world = twoRowWorld(17);
  const Map drawing = perturbed(world.map, 5.0, 18);
  const auto source = simulate(world, SimulationOptions{}, 5);
  HandmapEstimator estimator(drawing, EstimatorOptions{}, 1);
  Perception perception(source->info(), {});
  EXPECT_TRUE(estimator.swarms(50).empty());
  for (int i = 0; i < 15; ++i) {
    const auto observation = source->next();
    estimator.step(observation->time_s, observation->odometry, perception(*observation)->scan);
  }
  const Map refined = estimator.refinedMap();
  const std::vector<BuildingSwarm> swarms = estimator.swarms(50);
  ASSERT_GE(swarms.size(), 2u);
  for (const BuildingSwarm& swarm : swarms) {
    ASSERT_EQ(swarm.members.size(), 50u);
    const Building& building = refined.buildings[swarm.building];
    if (building.doubt) continue;
    double squares = 0.0;
    for (const Rectangle& member : swarm.members) {
      squares += std::pow(member.centre.x() - building.box().centre.x(), 2);
    }
    EXPECT_NEAR(std::sqrt(squares / 50.0), building.estimate->sigma_x,
                0.4 * building.estimate->sigma_x)
        << building.id;
  }
}

int doubtful(const Map& refined) {
  return static_cast<int>(std::ranges::count_if(
      refined.buildings, [](const Building& building) { return building.doubt.has_value(); }));
}

TEST(HandmapEstimator, DoubtsNoBuildingThatIsStillAhead) {
  const World world = twoRowWorld(17);
  const Map drawing = perturbed(world.map, 10.0, 18);
  for (const int observations : {1, 3}) {
    EXPECT_EQ(doubtful(runThrough(world, drawing, observations).refined), 0) << observations;
  }
}

TEST(HandmapEstimator, DoubtsABuildingThatItPassedAndDidNotSee) {
  World world = twoRowWorld(17);
  const Map drawing = world.map;
  world.map.buildings.erase(world.map.buildings.begin() + 1);
  const Outcome run = runThrough(world, drawing, 1000);
  EXPECT_EQ(doubtful(run.refined), 1);
  EXPECT_TRUE(run.refined.buildings[1].doubt.has_value());
}

TEST(HandmapEstimator, RefusesADrawingWithoutBuildingsOrStart) {
  Map map = twoRowWorld(1).map;
  map.start.reset();
  EXPECT_THROW(HandmapEstimator(map, EstimatorOptions{}, 1), Error);
  map = twoRowWorld(1).map;
  map.buildings.clear();
  EXPECT_THROW(HandmapEstimator(map, EstimatorOptions{}, 1), Error);
}

}  // namespace
}  // namespace handmap
