#include "app/gui/run/run_score.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Map rowAt(double x) {
  Map map;
  Building building;
  building.id = "N1";
  building.shape = Rectangle{{x, 10.0}, 20.0, 10.0, 0.0};
  map.buildings = {building};
  return map;
}

std::vector<StampedPose> trajectoryBeside(double y) {
  return {{0.0, {0.0, y, 0.0}}, {1.0, {5.0, y, 0.0}}, {2.0, {10.0, y, 0.0}}};
}

Snapshot atTheEnd() {
  Snapshot last;
  last.odometry = SharedListWriter(trajectoryBeside(2.0)).share();
  last.trajectory = SharedListWriter(trajectoryBeside(0.5)).share();
  return last;
}

TEST(RunScore, ComparesDrawingAndWayWithTheTruth) {
  const RunScore score =
      scoreRun(rowAt(3.0), rowAt(1.0), rowAt(0.0), atTheEnd(), trajectoryBeside(0.0));
  ASSERT_TRUE(score.maps && score.trajectories);
  EXPECT_NEAR(score.maps->drawn.x, 3.0, 1e-9);
  EXPECT_NEAR(score.maps->corrected.x, 1.0, 1e-9);
  EXPECT_NEAR(score.trajectories->odometry.rms_m, 2.0, 1e-9);
  EXPECT_NEAR(score.trajectories->corrected.rms_m, 0.5, 1e-9);
  EXPECT_TRUE(scoreInWords(score).contains("buildings along x 3.00 → 1.00 m"));
  EXPECT_TRUE(scoreInWords(score).contains("way of the robot 2.00 → 0.50 m"));
  EXPECT_TRUE(scoreTable(score).contains("overlap with truth"));
}

TEST(RunScore, SaysNothingWithoutATruth) {
  const RunScore score = scoreRun(rowAt(3.0), rowAt(1.0), {}, atTheEnd(), {});
  EXPECT_FALSE(score.maps || score.trajectories);
  EXPECT_TRUE(scoreInWords(score).isEmpty());
  EXPECT_TRUE(scoreTable(score).isEmpty());
}

}  // namespace
}  // namespace handmap
