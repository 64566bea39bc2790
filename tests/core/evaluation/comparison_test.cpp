#include "core/evaluation/comparison.h"

#include <gtest/gtest.h>

#include "core/evaluation/rigid_motion.h"

namespace handmap {
namespace {

Building box(const std::string& id, double x, double y, double width, double depth,
             double heading = 0.0) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, width, depth, heading};
  return building;
}

Map street() {
  Map map;
  map.start = Pose2{};
  map.buildings = {box("L1", 20, 20, 30, 10), box("L2", 60, 22, 30, 10),
                   box("R1", 40, -20, 40, 12)};
  return map;
}

TEST(CompareMaps, TheTruthHasNoError) {
  for (const bool aligned : {false, true}) {
    const MapComparison comparison = compareMaps(street(), street(), aligned);
    ASSERT_EQ(comparison.buildings.size(), 3U);
    for (const BuildingError& error : comparison.buildings) {
      EXPECT_NEAR(error.x, 0.0, 1e-12);
      EXPECT_NEAR(error.front, 0.0, 1e-12);
      EXPECT_NEAR(error.width, 0.0, 1e-12);
      EXPECT_NEAR(error.iou, 1.0, 1e-6);
      EXPECT_TRUE(error.overlaps);
    }
  }
}

TEST(CompareMaps, FrontIsTheWallTowardsTheRobot) {
  Map map = street();
  map.buildings[0] = box("L1", 21, 20.5, 34, 12);  // front wall from y = 15 to 14.5
  map.buildings[2] = box("R1", 38, -19, 40, 12);   // front wall from y = -14 to -13
  const MapComparison comparison = compareMaps(map, street(), false);
  EXPECT_NEAR(comparison.buildings[0].x, 1.0, 1e-12);
  EXPECT_NEAR(comparison.buildings[2].x, -2.0, 1e-12);
  EXPECT_NEAR(comparison.buildings[0].front, 0.5, 1e-12);
  EXPECT_NEAR(comparison.buildings[0].width, 4.0, 1e-12);
  EXPECT_NEAR(comparison.buildings[2].front, 1.0, 1e-12);
  const double joint = 30 * 10 + 34 * 12 - 30 * 10;
  EXPECT_NEAR(comparison.buildings[0].iou, 300 / joint, 1e-6);
}

TEST(CompareMaps, ASideDrawnAsWidthOrAsDepthIsTheSame) {
  Map truth = street();
  truth.buildings[1] = box("L2", 60, 22, 10, 30, kPi / 2.0);
  Map map = street();
  map.buildings[1] = box("L2", 60, 21, 32, 10);
  const BuildingError error = compareMaps(map, truth, false).buildings[1];
  EXPECT_NEAR(error.front, 1.0, 1e-12);
  EXPECT_NEAR(error.width, 2.0, 1e-12);
  EXPECT_NEAR(error.x, 0.0, 1e-12);
}

TEST(CompareMaps, TheRouteTellsTheFrontBeforeTheStartDoes) {
  Map truth = street();
  truth.route = {{0, 40}, {80, 40}};
  truth.start = Pose2{0, 40, 0};
  Map map = truth;
  map.buildings[0] = box("L1", 20, 21, 30, 10);
  EXPECT_NEAR(compareMaps(map, truth, false).buildings[0].front, 1.0, 1e-12);
  truth.route.clear();
  truth.start.reset();  // now the middle of the map, below L1
  EXPECT_NEAR(compareMaps(map, truth, false).buildings[0].front, -1.0, 1e-12);
}

TEST(CompareMaps, AlignmentTakesOutShiftAndTurn) {
  const Pose2 motion{3.0, -2.0, 0.1};
  Map map = street();
  for (Building& building : map.buildings) {
    Rectangle shape = building.box();
    shape.centre = motion.toOuter(shape.centre);
    shape.heading += motion.heading;
    building.shape = shape;
  }
  EXPECT_GT(compareMaps(map, street(), false).mean().x, 1.0);
  const MapComparison aligned = compareMaps(map, street(), true);
  EXPECT_NEAR(aligned.mean().x, 0.0, 1e-9);
  EXPECT_NEAR(aligned.mean().front, 0.0, 1e-9);
  EXPECT_NEAR(aligned.mean().iou, 1.0, 1e-6);
  EXPECT_NEAR(aligned.alignment.heading, -0.1, 1e-9);
}

TEST(CompareMaps, BuildingsOfOneMapOnlyAreNamed) {
  Map map = street();
  map.buildings[1].id = "L9";
  map.buildings[2] = box("R1", 400, -20, 40, 12);
  const MapComparison comparison = compareMaps(map, street(), false);
  EXPECT_EQ(comparison.missing, std::vector<std::string>{"L2"});
  EXPECT_EQ(comparison.extra, std::vector<std::string>{"L9"});
  EXPECT_FALSE(comparison.buildings[1].overlaps);
  EXPECT_EQ(comparison.buildings[1].iou, 0.0);
  EXPECT_EQ(comparison.mean().buildings, 2);
  EXPECT_NEAR(comparison.mean().x, 180.0, 1e-9);
  EXPECT_NEAR(comparison.mean({"L1"}).x, 0.0, 1e-9);
  EXPECT_EQ(comparison.mean({"L2"}).buildings, 0);
}

TEST(CompareMaps, PolygonsAreComparedByTheirBoxes) {
  Map truth = street();
  truth.buildings[0].shape = Polygon{{5, 15}, {35, 15}, {35, 20}, {20, 20}, {20, 25}, {5, 25}};
  const BuildingError error = compareMaps(street(), truth, false).buildings[0];
  EXPECT_NEAR(error.x, 0.0, 1e-9);
  EXPECT_NEAR(error.front, 0.0, 1e-9);
  EXPECT_NEAR(error.iou, 225.0 / 300.0, 1e-6);
}

TEST(RigidMotion, OfFewPoints) {
  EXPECT_EQ(bestRigidMotion({}, {}), Pose2{});
  EXPECT_EQ(bestRigidMotion({{1, 2}}, {{4, 6}}), (Pose2{3, 4, 0}));
}

TEST(CompareTrajectories, MeasuresAtCommonTimes) {
  std::vector<StampedPose> truth;
  for (int i = 0; i <= 20; ++i) truth.push_back({0.5 * i, {0.5 * i, 0.0, 0.0}});
  const std::vector<StampedPose> estimate{
      {0, {0, 0, 0}}, {4, {4, 3, 0.1}}, {8, {8, 4, -0.1}}, {50, {99, 99, 0}}};
  const auto error = compareTrajectories(estimate, Trajectory(truth, "truth"));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->poses, 3);
  EXPECT_NEAR(error->rms_m, std::sqrt(25.0 / 3.0), 1e-9);
  EXPECT_NEAR(error->max_m, 4.0, 1e-9);
  EXPECT_NEAR(error->end_m, 4.0, 1e-9);
  EXPECT_NEAR(error->rms_heading, std::sqrt(0.02 / 3.0), 1e-9);
  EXPECT_NEAR(error->length_m, 8.0, 1e-9);
  EXPECT_LT(error->aligned_rms_m, 1.2);
  EXPECT_GT(error->aligned_rms_m, 0.1);
  EXPECT_FALSE(compareTrajectories({{50, {}}}, Trajectory(truth, "truth")));
}

}  // namespace
}  // namespace handmap
