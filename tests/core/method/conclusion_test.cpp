#include "core/method/conclusion.h"

#include <gtest/gtest.h>

#include "core/map/certainty.h"
#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

TEST(Conclusion, DoesNotTakeBackWhatWasFoundWithoutHavingSeenMore) {
  const auto seen = [](double x, std::size_t walls) {
    Building building;
    building.shape = Rectangle{{x, 0.0}, 20.0, 10.0, 0.0};
    building.estimate = Estimate{0.3, 0.3, 0.3, 4};
    Sides sides{};
    for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = {0.3, i < walls};
    setSides(building, sides);
    return building;
  };
  Building drawn;
  drawn.shape = seen(0.0, 0).shape;
  EXPECT_FALSE(isBetterFounded(seen(0.0, 1), seen(6.0, 1), drawn));
  EXPECT_TRUE(isBetterFounded(seen(0.0, 2), seen(6.0, 1), drawn));
  EXPECT_TRUE(isBetterFounded(seen(11.0, 1), seen(6.0, 1), drawn)) << "it was fitted";
  EXPECT_TRUE(isBetterFounded(seen(0.0, 1), drawn, drawn)) << "nothing else was found";
}

const Polygon kTrueHouse = Rectangle{{20.0, 12.0}, 14.0, 8.0, 0.1}.corners();

/// Two houses drawn 3.6 m off, found at `found`.
struct TwoHouses {
  Map drawing;
  RunKnowledge known;

  explicit TwoHouses(const std::vector<Polygon>& found)
      : known{{}, {}, std::nullopt, {}, {}, {}, SeenFrames(40.0), {}} {
    const Drive drive = drivePast({kTrueHouse, moved(kTrueHouse, {25.0, 0.0})});
    drawing.start = Pose2{};
    for (const double x : {3.0, 28.0}) {
      Building building;
      building.shape = moved(kTrueHouse, {x, 2.0});
      drawing.buildings.push_back(building);
    }
    known.alone = {TrajectoryHypothesis::By::Odometry, drive.way};
    known.buildings = {TrajectoryHypothesis::By::Buildings, drive.way};
    known.found = drawing;
    for (std::size_t b = 0; b < found.size(); ++b) {
      known.found.buildings[b].shape = found[b];
      known.found.buildings[b].estimate = Estimate{0.3, 0.3, 0.3, 20};
    }
    known.predicted = [drawn = drawing] { return drawn; };
    known.seen = drive.seen;
    known.sharpness = [](const std::vector<Pose2>&) { return 1.0; };
  }
};

TEST(Conclusion, BelievesBuildingsThatStandWhereWallsWereSeen) {
  const TwoHouses place({kTrueHouse, moved(kTrueHouse, {25.0, 0.0})});
  const auto conclusion = conclude(place.drawing, place.known, 1);
  ASSERT_TRUE(conclusion);
  EXPECT_FALSE(conclusion->unfounded);
  EXPECT_EQ(conclusion->trajectory.by, TrajectoryHypothesis::By::Buildings);
}

TEST(Conclusion, HasNothingToDropWhereNothingWasFound) {
  const TwoHouses place({});
  const auto conclusion = conclude(place.drawing, place.known, 1);
  ASSERT_TRUE(conclusion);
  EXPECT_FALSE(conclusion->unfounded);
}

TEST(Conclusion, DropsBuildingsThatRaysPassThrough) {
  // Side walls are on those of the true ones, fronts are not.
  const TwoHouses place({moved(kTrueHouse, {0.0, -3.0}), moved(kTrueHouse, {25.0, -3.0})});
  const auto conclusion = conclude(place.drawing, place.known, 1);
  ASSERT_TRUE(conclusion);
  EXPECT_TRUE(conclusion->unfounded);
  EXPECT_EQ(conclusion->trajectory.by, TrajectoryHypothesis::By::Odometry);
  EXPECT_GT(intersectionOverUnion(conclusion->map.buildings[0].footprint(), kTrueHouse), 0.7);
}

TEST(Conclusion, KeepsAWayThatIsClearlySharperThoughItsBuildingsAreDropped) {
  TwoHouses place({moved(kTrueHouse, {0.0, -3.0}), moved(kTrueHouse, {25.0, -3.0})});
  for (Pose2& pose : place.known.alone.poses) pose.heading += 0.01;
  place.known.sharpness = [&](const std::vector<Pose2>& poses) {
    return poses.back().heading == place.known.alone.poses.back().heading ? 1.0 : 1.1;
  };
  const auto conclusion = conclude(place.drawing, place.known, 1);
  ASSERT_TRUE(conclusion);
  EXPECT_TRUE(conclusion->unfounded);
  EXPECT_EQ(conclusion->trajectory.by, TrajectoryHypothesis::By::Buildings);
  EXPECT_GT(intersectionOverUnion(conclusion->map.buildings[0].footprint(), kTrueHouse), 0.7);
}

TEST(Conclusion, BelievesTheWayThatImagesTold) {
  TwoHouses place({kTrueHouse, moved(kTrueHouse, {25.0, 0.0})});
  place.known.alone.by = TrajectoryHypothesis::By::Scans;
  place.known.alone.followed = true;
  const auto conclusion = conclude(place.drawing, place.known, 1);
  ASSERT_TRUE(conclusion);
  EXPECT_FALSE(conclusion->unfounded);
  EXPECT_EQ(conclusion->trajectory.by, TrajectoryHypothesis::By::Scans);
  EXPECT_GT(intersectionOverUnion(conclusion->map.buildings[0].footprint(), kTrueHouse), 0.7);
}

}  // namespace
}  // namespace handmap
