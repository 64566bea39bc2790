#include "core/outlines/map_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/outlines/constants.h"
#include "core/outlines/terraces.h"
#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

using namespace outlines;

const Polygon kFittedHouse = Rectangle{{20.0, 12.0}, 14.0, 8.0, 0.1}.corners();
const Polygon kEll = {{35, 8}, {50, 8}, {50, 20}, {44, 20}, {44, 13}, {35, 13}};

OutlineTask taskFor(const Polygon& drawn, bool rectangle) {
  OutlineTask task;
  task.as_drawn = task.drawn = task.start = drawn;
  task.shift_m = task.drawn_shift_m = task.size_m = 3.0;
  task.rectangle = rectangle;
  return task;
}

TEST(MapFit, MovesHousesToWhereTheyAre) {
  const Drive drive = drivePast({kFittedHouse, kEll});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  ASSERT_TRUE(placed.showsStructure());
  const auto results = fitOutlines(
      {taskFor(moved(kFittedHouse, {2.5, 1.5}), true), taskFor(moved(kEll, {-2.0, 2.0}), false)},
      placed, 40.0, 1);
  ASSERT_EQ(results.size(), 2U);
  for (const OutlineResult& result : results) {
    EXPECT_EQ(result.verdict, Verdict::Moved);
    ASSERT_TRUE(result.estimate);
    EXPECT_GT(result.estimate->observations, 10);
  }
  EXPECT_GT(intersectionOverUnion(results[0].outline, kFittedHouse), 0.85);
  EXPECT_GT(intersectionOverUnion(results[1].outline, kEll), 0.85);
}

TEST(MapFit, SaysHowWellEachSideIsKnown) {
  // So wide that neither its ends nor its back were seen.
  const Polygon wide = Rectangle{{30.0, 12.0}, 200.0, 8.0, 0.0}.corners();
  const Drive drive = drivePast({wide, moved(kFittedHouse, {0.0, -25.0})});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  const auto results = fitOutlines(
      {taskFor(wide, true), taskFor(moved(kFittedHouse, {0.5, -25.5}), true)}, placed, 40.0, 1);
  ASSERT_TRUE(results.at(1).estimate);
  EXPECT_LT(results[1].estimate->sigma_x, 0.5);
  const OutlineScorer scorer(placed, 40.0, {}, kNobody, {30.0, 12.0}, 130.0);
  EXPECT_GT(spreadOfSide(wide, {0.0, 1.0}, 3.0, scorer), 2.0);
  EXPECT_LT(spreadOfSide(wide, {0.0, -1.0}, 3.0, scorer), 0.5);
}

TEST(MapFit, KeepsAHouseThatNothingSpeaksFor) {
  const Drive drive = drivePast({kFittedHouse});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  const Polygon far = Rectangle{{30.0, -120.0}, 10.0, 8.0, 0.0}.corners();
  const auto results = fitOutlines({taskFor(far, true)}, placed, 40.0, 1);
  EXPECT_EQ(results.at(0).verdict, Verdict::Kept);
  EXPECT_EQ(results[0].outline, far);
  EXPECT_FALSE(results[0].estimate);
}

TEST(MapFit, DoesNotLetNeighboursTakeOneWall) {
  const Drive drive = drivePast({kFittedHouse});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  const auto results = fitOutlines({taskFor(moved(kFittedHouse, {0.5, 0.5}), true),
                                    taskFor(moved(kFittedHouse, {6.0, 3.0}), true)},
                                   placed, 40.0, 1);
  EXPECT_EQ(results.at(0).verdict, Verdict::Moved);
  EXPECT_LT(intersectionOverUnion(results[0].outline, results[1].outline), 0.6);
}

TEST(MapFit, GivesAWallBackToTheNeighbourThatItIsOf) {
  const Polygon left = Rectangle{{16.0, 12.0}, 20.0, 8.0, 0.0}.corners();
  const Polygon right = Rectangle{{40.0, 11.0}, 18.0, 8.0, 0.0}.corners();
  const Drive drive = drivePast({left, right});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  // The left one is drawn nearly as long as both.
  OutlineTask both = taskFor(Rectangle{{23.0, 12.5}, 33.0, 8.0, 0.0}.corners(), true);
  both.size_m = 12.0;
  const auto results =
      fitOutlines({both, taskFor(moved(right, {1.0, 1.0}), true)}, placed, 40.0, 1);
  EXPECT_EQ(results.at(1).verdict, Verdict::Moved);
  EXPECT_GT(intersectionOverUnion(results[0].outline, left), 0.7);
  EXPECT_GT(intersectionOverUnion(results[1].outline, right), 0.8);
}

TEST(MapFit, ANearerHouseIsTheOneThoughAnotherExplainsMore) {
  const Polygon house = Rectangle{{14.0, 17.0}, 10.0, 8.0, 0.0}.corners();
  const Polygon undrawn = Rectangle{{29.0, 9.0}, 16.0, 8.0, 0.0}.corners();
  const Drive drive = drivePast({house, undrawn});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  const auto results = fitOutlines({taskFor(moved(house, {3.0, -2.0}), true)}, placed, 40.0, 1);
  EXPECT_EQ(results.at(0).verdict, Verdict::Moved);
  EXPECT_GT(intersectionOverUnion(results[0].outline, house), 0.7);
}

TEST(MapFit, AHouseBecomesNoVanHoweverUnsureItsSizeIs) {
  const Polygon van = Rectangle{{24.0, 9.0}, 5.0, 3.2, 0.0}.corners();
  const Drive drive = drivePast({van});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  OutlineTask house = taskFor(Rectangle{{22.0, 12.0}, 13.0, 17.0, 0.0}.corners(), true);
  house.shift_m = house.drawn_shift_m = house.size_m = 10.0;
  const Rectangle box = boundingRectangle(fitOutlines({house}, placed, 40.0, 1).at(0).outline, 0.0);
  EXPECT_GT(std::min(box.width / 13.0, box.depth / 17.0), 0.4);
}

TEST(MapFit, IsTheSameEachTime) {
  const Drive drive = drivePast({kFittedHouse});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  const std::vector<OutlineTask> tasks = {taskFor(moved(kFittedHouse, {2.0, 1.0}), true)};
  EXPECT_EQ(fitOutlines(tasks, placed, 40.0, 5).at(0).outline,
            fitOutlines(tasks, placed, 40.0, 5).at(0).outline);
}

TEST(MapFit, ComesBackEmptyWhenStopped) {
  const Drive drive = drivePast({kFittedHouse});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_TRUE(
      fitOutlines({taskFor(kFittedHouse, true)}, placed, 40.0, 1, stop.get_token()).empty());
}

/// Four houses wall to wall, drawn as people do: a middle one twice as wide would explain as much.
TEST(MapFit, LeavesEachHouseOfATerraceItsPlace) {
  const std::vector<Polygon> houses = {Rectangle{{9.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{19.5, 12.0}, 11.0, 8.0, 0.0}.corners(),
                                       Rectangle{{29.5, 12.0}, 9.0, 8.0, 0.0}.corners(),
                                       Rectangle{{39.5, 12.0}, 11.0, 8.0, 0.0}.corners()};
  const std::vector<Polygon> drawn = {Rectangle{{7.0, 14.0}, 8.0, 9.0, 0.05}.corners(),
                                      Rectangle{{22.5, 11.0}, 13.0, 7.0, -0.05}.corners(),
                                      Rectangle{{31.5, 14.5}, 7.5, 7.0, 0.08}.corners(),
                                      Rectangle{{37.0, 10.5}, 12.0, 10.0, 0.0}.corners()};
  const Drive drive = drivePast(houses);
  std::vector<OutlineTask> tasks;
  for (const Polygon& house : drawn) tasks.push_back(taskFor(house, true));
  const auto results = fitOutlines(tasks, placeRays(drive.seen, drive.way), 40.0, 1);
  ASSERT_EQ(results.size(), houses.size());
  double drawn_share = 0.0;
  double share = 0.0;
  for (std::size_t i = 0; i < houses.size(); ++i) {
    EXPECT_EQ(results[i].verdict, Verdict::Moved) << i;
    drawn_share += intersectionOverUnion(drawn[i], houses[i]) / 4.0;
    share += intersectionOverUnion(results[i].outline, houses[i]) / 4.0;
  }
  EXPECT_GT(share, drawn_share + 0.05);
}

/// The last house is drawn beyond the end of the row, where a van stands.
TEST(MapFit, MakesNoVanOfTheLastHouseOfATerrace) {
  const std::vector<Polygon> houses = {Rectangle{{15.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{25.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{35.0, 12.0}, 10.0, 8.0, 0.0}.corners()};
  const Polygon van = Rectangle{{45.0, 11.0}, 5.0, 3.0, 0.0}.corners();
  const std::vector<Polygon> drawn = {Rectangle{{16.0, 13.0}, 9.0, 7.0, 0.0}.corners(),
                                      Rectangle{{28.0, 11.0}, 11.0, 9.0, 0.03}.corners(),
                                      Rectangle{{42.0, 12.0}, 9.0, 8.0, 0.0}.corners()};
  std::vector<Polygon> there = houses;
  there.push_back(van);
  const Drive drive = drivePast(there);
  std::vector<OutlineTask> tasks;
  for (const Polygon& house : drawn) tasks.push_back(taskFor(house, true));
  const auto results = fitOutlines(tasks, placeRays(drive.seen, drive.way), 40.0, 1);
  // Little tells how deep they are.
  for (std::size_t i = 0; i < houses.size(); ++i) {
    EXPECT_GT(intersectionOverUnion(results.at(i).outline, houses[i]), 0.55) << i;
    const Bounds bounds = boundsOf(results.at(i).outline);
    const Bounds right = boundsOf(houses[i]);
    EXPECT_NEAR(bounds.low.x(), right.low.x(), 2.0) << i;
    EXPECT_NEAR(bounds.high.x(), right.high.x(), 2.0) << i;
    EXPECT_NEAR(bounds.low.y(), right.low.y(), 0.5) << i;
  }
}

/// Four houses wall to wall of which nobody drew the two in the middle: their walls are not those
/// of the others, which would explain them.
TEST(MapFit, LeavesHousesOfATerraceThatNobodyDrewToNobody) {
  const std::vector<Polygon> houses = {Rectangle{{9.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{19.0, 12.6}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{29.0, 12.0}, 10.0, 8.0, 0.0}.corners(),
                                       Rectangle{{39.0, 12.7}, 10.0, 8.0, 0.0}.corners()};
  const Drive drive = drivePast(houses);
  const auto results =
      fitOutlines({taskFor(Rectangle{{12.0, 13.0}, 8.0, 8.0, 0.0}.corners(), true),
                   taskFor(Rectangle{{37.5, 11.0}, 9.0, 9.0, 0.0}.corners(), true)},
                  placeRays(drive.seen, drive.way), 40.0, 1);
  EXPECT_GT(intersectionOverUnion(results.at(0).outline, houses[0]), 0.65);
  EXPECT_GT(intersectionOverUnion(results.at(1).outline, houses[3]), 0.65);
}

/// What has wings has more than one face to a side.
TEST(Terraces, HaveNoBuildingsWithWings) {
  const Polygon house = Rectangle{{29.0, 12.0}, 12.0, 8.0, 0.0}.corners();
  const Polygon another = Rectangle{{41.0, 12.0}, 12.0, 8.0, 0.0}.corners();
  const Polygon undrawn = Rectangle{{17.0, 12.6}, 12.0, 8.0, 0.0}.corners();
  const auto divided = [&](const Polygon& beside) {
    const Drive drive = drivePast({undrawn, house, beside});
    const std::vector<OutlineTask> tasks = {taskFor(house, true), taskFor(beside, false)};
    const std::vector<std::optional<FittedOutline>> places = {FittedOutline{house},
                                                              FittedOutline{beside}};
    return dividedTerraces(tasks, places, placeRays(drive.seen, drive.way), 40.0, {}).size();
  };
  EXPECT_EQ(divided(another), 2U);
  EXPECT_EQ(divided(kEll), 0U);
}

/// Drawn between two parts of the row.
TEST(Terraces, DoubtAHouseThatMayBeItsNeighbour) {
  const Polygon first = Rectangle{{9.0, 12.0}, 10.0, 8.0, 0.0}.corners();
  const Polygon second = Rectangle{{19.0, 12.6}, 10.0, 8.0, 0.0}.corners();
  const Polygon third = Rectangle{{29.0, 12.0}, 10.0, 8.0, 0.0}.corners();
  const Polygon last = Rectangle{{39.0, 12.7}, 10.0, 8.0, 0.0}.corners();
  const Drive drive = drivePast({first, second, third, last});
  const std::vector<std::optional<FittedOutline>> places = {
      FittedOutline{first}, FittedOutline{second}, FittedOutline{last}};
  const auto doubt_of_drawn_at = [&](double x) {
    const Polygon drawn = moved(second, {x - 19.0, 0.0});
    const std::vector<OutlineTask> tasks = {taskFor(first, true), taskFor(drawn, true),
                                            taskFor(last, true)};
    const auto houses = dividedTerraces(tasks, places, placeRays(drive.seen, drive.way), 40.0, {});
    return std::ranges::find(houses, 1U, &TerraceHouse::building)->in_row.doubt;
  };
  EXPECT_LT(doubt_of_drawn_at(18.5), 0.2);
  EXPECT_GT(doubt_of_drawn_at(24.5), 0.25);
}

/// One was found so shallow that rays pass behind it, through a gap of the row.
TEST(Terraces, AreAsDeepAsTheyAreDrawnWhereNobodySawThat) {
  const Polygon undrawn = Rectangle{{17.0, 12.6}, 12.0, 8.0, 0.0}.corners();
  const Polygon first = Rectangle{{29.0, 12.0}, 12.0, 8.0, 0.0}.corners();
  const Polygon second = Rectangle{{41.0, 12.5}, 12.0, 8.0, 0.0}.corners();
  const Polygon shallow = Rectangle{{29.0, 10.0}, 12.0, 4.0, 0.0}.corners();
  const Drive drive = drivePast({undrawn, first, second});
  const std::vector<OutlineTask> tasks = {taskFor(first, true), taskFor(second, true)};
  const auto houses = dividedTerraces(tasks, {FittedOutline{shallow}, FittedOutline{second}},
                                      placeRays(drive.seen, drive.way), 40.0, {});
  ASSERT_EQ(houses.size(), 2U);
  for (const TerraceHouse& house : houses) {
    ASSERT_TRUE(house.place);
    const Polygon& there = house.building == 0 ? first : second;
    EXPECT_GT(intersectionOverUnion(house.place->outline, there), 0.85) << house.building;
  }
}

/// Drawn behind the row, and found where it cannot be.
TEST(Terraces, HaveNoRoomForOneWhoseOtherPlaceIsWorseStill) {
  const Polygon first = Rectangle{{17.0, 12.6}, 12.0, 8.0, 0.0}.corners();
  const Polygon second = Rectangle{{29.0, 12.0}, 12.0, 8.0, 0.0}.corners();
  const Polygon undrawn = Rectangle{{41.0, 12.5}, 12.0, 8.0, 0.0}.corners();
  const Polygon behind = moved(second, {1.0, 10.0});
  const Drive drive = drivePast({first, second, undrawn});
  const std::vector<OutlineTask> tasks = {taskFor(first, true), taskFor(second, true),
                                          taskFor(behind, true)};
  const std::vector<std::optional<FittedOutline>> places = {
      FittedOutline{first}, FittedOutline{second}, FittedOutline{moved(behind, {0.0, 50.0})}};
  const auto houses = dividedTerraces(tasks, places, placeRays(drive.seen, drive.way), 40.0, {});
  ASSERT_EQ(houses.size(), 2U);
  EXPECT_EQ(houses[0].building, 0U);
  EXPECT_EQ(houses[1].building, 1U);
  EXPECT_TRUE(houses[1].place);
}

TEST(MapFit, DividesNoHouseOnWhichAnotherIsDrawnToo) {
  const Drive drive = drivePast({kFittedHouse});
  const auto results = fitOutlines({taskFor(moved(kFittedHouse, {1.0, 1.0}), true),
                                    taskFor(moved(kFittedHouse, {3.0, 7.0}), true)},
                                   placeRays(drive.seen, drive.way), 40.0, 1);
  EXPECT_GT(std::max(intersectionOverUnion(results.at(0).outline, kFittedHouse),
                     intersectionOverUnion(results.at(1).outline, kFittedHouse)),
            0.85);
}

}  // namespace
}  // namespace handmap
