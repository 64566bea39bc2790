#include "core/session/run_warnings.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Map oneBuilding() {
  Map map;
  map.start = Pose2{};
  Building north;
  north.id = "N";
  north.shape = Rectangle{{10.0, 60.0}, 20.0, 10.0, 0.0};
  map.buildings = {north};
  return map;
}

Map corrected(int observations) {
  Map map = oneBuilding();
  map.buildings[0].estimate = Estimate{1.0, 1.0, 1.0, observations};
  return map;
}

std::vector<RunWarning> warningsOf(const RunCounts& counts, const Map& refined = corrected(0),
                                   double range_limit_m = 80.0, bool refine = true) {
  const std::vector<StampedPose> way{{0.0, {0.0, 0.0, 0.0}}, {1.0, {20.0, 0.0, 0.0}}};
  return runWarnings({counts, range_limit_m, oneBuilding(), refined, way, refine});
}

bool says(const std::vector<RunWarning>& warnings, const std::string& code,
          const std::string& words) {
  return warnings.size() == 1 && warnings[0].code == code && !warnings[0].hint.empty() &&
         warnings[0].message.find(words) != std::string::npos;
}

TEST(RunWarnings, AGoodRunHasNone) {
  EXPECT_TRUE(warningsOf({10, 8, false, 1000, 300, 20.0}, corrected(5)).empty());
}

TEST(RunWarnings, TellsWhyNothingWasRecognised) {
  EXPECT_TRUE(says(warningsOf({10, 0, false, 0, 0, 0.0}), "nothing_recognised",
                   "Nothing came back from within 80 m"));
  EXPECT_TRUE(
      says(warningsOf({10, 0, false, 1234, 0, 0.0}), "nothing_recognised", "None of 1234 returns"));
  EXPECT_TRUE(says(warningsOf({10, 0, true, 0, 0, 0.0}), "nothing_recognised", "images"));
  EXPECT_TRUE(says(warningsOf({10, 0, false, 1234, 99, 31.0}, corrected(0), 40.0),
                   "nothing_recognised", "no nearer than 55 m to a drawn building"));
  EXPECT_TRUE(says(warningsOf({10, 0, false, 1234, 99, 31.0}), "nothing_recognised",
                   "Walls were seen in 99 directions, up to 31 m away"));
}

TEST(RunWarnings, TellsThatNothingWasCorrected) {
  const RunCounts seen{10, 8, false, 1000, 300, 20.0};
  EXPECT_TRUE(says(warningsOf(seen), "nothing_corrected", "8 of 10 observations"));
  EXPECT_TRUE(warningsOf(seen, corrected(0), 80.0, false).empty()) << "nothing was to be corrected";
}

TEST(RunWarnings, SaysOnceThatWhatWasFoundWasDropped) {
  const RunCounts seen{10, 8, false, 1000, 300, 20.0};
  const Map drawing = oneBuilding();
  const Map refined = corrected(0);
  const std::vector<StampedPose> way{{0.0, {0.0, 0.0, 0.0}}, {1.0, {20.0, 0.0, 0.0}}};
  RunOutcome outcome{seen, 80.0, drawing, refined, way, true};
  outcome.of_method = {{"buildings_dropped", "Some were found and dropped.", "Drive closer."}};
  EXPECT_TRUE(says(runWarnings(outcome), "buildings_dropped", "dropped"));
  outcome.of_method[0].code = "start_refuted";
  ASSERT_EQ(runWarnings(outcome).size(), 2U);
  EXPECT_EQ(runWarnings(outcome)[1].code, "nothing_corrected");
}

TEST(RunWarnings, TellsThatCamerasAreNearSighted) {
  EXPECT_TRUE(
      says(warningsOf({10, 8, true, 0, 300, 15.4}), "nothing_corrected", "no wall beyond 15 m"));
  EXPECT_FALSE(says(warningsOf({10, 8, true, 0, 300, 35.0}), "nothing_corrected", "no wall"));
  EXPECT_FALSE(says(warningsOf({10, 8, false, 900, 300, 15.4}), "nothing_corrected", "no wall"));
}

TEST(RunWarnings, TellsThatTheWayIsMostlyTheOdometrys) {
  EXPECT_TRUE(says(warningsOf({10, 4, false, 1000, 300, 20.0}, corrected(4)), "way_from_odometry",
                   "in 6 of 10 observations"));
  EXPECT_TRUE(warningsOf({10, 5, false, 1000, 300, 20.0}, corrected(4)).empty());
}

TEST(RunWarnings, TellsThatTheWayLeftWhatWasRecognised) {
  const RunCounts seen{10, 8, false, 1000, 300, 20.0};
  EXPECT_TRUE(says(warningsOf(seen, corrected(4), 54.0), "way_from_odometry",
                   "Along 100 % of the way, none of the drawn buildings"));
  EXPECT_TRUE(warningsOf(seen, corrected(4), 56.0).empty()) << "55 m away";
  EXPECT_TRUE(warningsOf(seen, corrected(4), 54.0, false).empty()) << "nothing was to be corrected";
}

TEST(RunWarnings, TellsThatTheEndWasAmongOtherWalls) {
  const Map refined = corrected(4);
  const std::vector<StampedPose> way{{0.0, {0.0, 0.0, 0.0}}, {1.0, {20.0, 0.0, 0.0}}};
  const RunCounts counts{10, 8, false, 1000, 300, 20.0};
  const auto ended = [&](double unrecognised_m) {
    return runWarnings({counts, 80.0, oneBuilding(), refined, way, true, unrecognised_m});
  };
  EXPECT_TRUE(ended(49.0).empty()) << "a gap between buildings";
  EXPECT_TRUE(says(ended(107.0), "end_unrecognised", "on the last 107 m"));
}

/// A grid of like houses, started a block off: what stands there is recognised again.
TEST(RunWarnings, TellsThatAPartOfTheWayWasAmongOtherWalls) {
  const std::vector<StampedPose> way{{0.0, {0.0, 0.0, 0.0}}, {1.0, {20.0, 0.0, 0.0}}};
  const Map refined = corrected(4);
  RunCounts counts{10, 8, false, 1000, 300, 20.0};
  FrameReport report;
  const auto drive = [&](double time_s, double unrecognised_m) {
    report.time_s = time_s;
    report.unrecognised_m = unrecognised_m;
    report.visible_buildings = 1;
    counts.add({}, report);
    return runWarnings({counts, 80.0, oneBuilding(), refined, way, true, unrecognised_m});
  };
  EXPECT_TRUE(drive(5.0, 49.0).empty()) << "a gap between buildings";
  drive(12.5, 82.0);
  EXPECT_TRUE(says(drive(13.0, 0.0), "part_unrecognised", "for 82 m on the way, up to 12.5 s"));
}

TEST(RunWarnings, CountsWhatComesBack) {
  RunCounts counts;
  Percept percept;
  percept.points.resize(7);
  percept.scan.rays = {{0.0F, 5.0F, 0.1F, 0.9F, true},
                       {0.1F, 30.0F, 0.1F, 0.9F, false},  // nothing came back
                       {0.2F, 40.0F, 0.1F, 0.1F, true}};  // hardly a wall
  FrameReport report;
  counts.add(percept, report);
  report.visible_buildings = 2;
  counts.add(percept, report);
  EXPECT_EQ(counts.observations, 2);
  EXPECT_EQ(counts.with_building, 1);
  EXPECT_EQ(counts.points, 14U);
  EXPECT_EQ(counts.walls, 2U);
  EXPECT_EQ(counts.farthest_m, 5.0);
}

TEST(RunWarnings, TellsWhereNothingToldTheMotion) {
  RunCounts counts{10, 8, false, 1000, 300, 20.0};
  FrameReport report;
  for (report.time_s = 4.5; report.time_s < 7.0; report.time_s += 1.0) {
    EXPECT_TRUE(warningsOf(counts, corrected(5)).empty());
    report.odometry_guessed = true;
    report.visible_buildings = 1;
    counts.add({}, report);
  }
  EXPECT_TRUE(says(warningsOf(counts, corrected(5)), "motion_guessed",
                   "at 3 of 13 observations, first at 4.5 s"));
}

TEST(RunWarnings, TellsThatGivenPosesMovedTheStart) {
  const Map map = corrected(5);
  const std::vector<StampedPose> way{{0.0, {0.0, 0.0, 0.0}}, {1.0, {20.0, 0.0, 0.0}}};
  const RunCounts counts{10, 8, false, 1000, 300, 20.0};
  const auto with = [&](const Pose2& drawn) {
    return runWarnings({counts, 80.0, map, map, way, true, 0.0, drawn});
  };
  EXPECT_TRUE(says(with({20.0, 0.0, 0.1}), "start_moved", "20.0 m and 6°"));
  EXPECT_TRUE(says(with({0.0, 0.0, 1.0}), "start_moved", "0.0 m and 57°"));
  EXPECT_TRUE(with({2.0, 1.0, 0.1}).empty()) << "a hand is off by as much";
}

}  // namespace
}  // namespace handmap
