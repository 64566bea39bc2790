// What findIssues() takes for a slip, and what not.
#include "core/map/issues.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "core/base/error.h"

namespace handmap {
namespace {

using Kind = Issue::Kind;

Building house(const std::string& id, double x, double y, double width = 10.0) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, width, 8.0, 0.0};
  return building;
}

Map goodMap() {
  Map map;
  map.start = Pose2{0.0, 0.0, 0.0};
  map.buildings = {house("A", 0.0, 20.0), house("B", 20.0, 20.0)};
  map.route = {{0.0, 0.0}, {40.0, 0.0}};
  return map;
}

std::vector<Kind> kindsOf(const Map& map) {
  std::vector<Kind> kinds;
  for (const Issue& issue : findIssues(map)) kinds.push_back(issue.kind);
  return kinds;
}

TEST(Issues, AGoodDrawingHasNone) { EXPECT_TRUE(findIssues(goodMap()).empty()); }

TEST(Issues, AnEmptyDrawingLacksEverything) {
  EXPECT_EQ(kindsOf({}), (std::vector{Kind::NoBuilding, Kind::NoStart}));
}

TEST(Issues, TheStartIsNotInABuildingAndNearTheRoute) {
  Map map = goodMap();
  map.start = Pose2{20.0, 21.0, 0.0};
  const std::vector<Issue> issues = findIssues(map);
  ASSERT_EQ(issues.size(), 2u);
  EXPECT_EQ(issues[0].kind, Kind::StartInBuilding);
  EXPECT_EQ(issues[0].ids, std::vector<std::string>{"B"});
  EXPECT_TRUE(issues[0].isGrave());
  EXPECT_EQ(issues[1].kind, Kind::RouteFarFromStart);
  EXPECT_NEAR(issues[1].metres, std::hypot(20.0, 21.0), 1e-9);
}

TEST(Issues, OverlapsAreMeasuredAndNeighboursMayTouch) {
  Map map = goodMap();
  map.buildings.push_back(house("C", 30.0, 20.0));  // wall to wall with B
  EXPECT_TRUE(findIssues(map).empty());
  map.buildings.push_back(house("D", 3.0, 20.0));
  const std::vector<Issue> issues = findIssues(map);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].kind, Kind::Overlap);
  EXPECT_EQ(issues[0].ids, (std::vector<std::string>{"A", "D"}));
  EXPECT_NEAR(issues[0].metres, 7.0 * 8.0, 1e-6);
  ASSERT_TRUE(issues[0].at);
  EXPECT_LT((*issues[0].at - Vec2(1.5, 20.0)).norm(), 1e-9);
  EXPECT_EQ(inWords(issues[0]), "A and D overlap by 56.0 m²");
}

TEST(Issues, TheRouteLeadsAroundBuildings) {
  Map map = goodMap();
  map.route = {{0.0, 0.0}, {20.0, 12.0}, {20.0, 30.0}};  // no point of it lies in B
  const std::vector<Issue> issues = findIssues(map);
  ASSERT_EQ(issues.size(), 1u);
  EXPECT_EQ(issues[0].kind, Kind::RouteInBuilding);
  EXPECT_EQ(issues[0].ids, std::vector<std::string>{"B"});
  ASSERT_TRUE(issues[0].at);
  EXPECT_NEAR(issues[0].at->x(), 20.0, 1e-9);
  EXPECT_GE(issues[0].at->y(), 16.0 - 1e-9);
}

TEST(Issues, OutlinesThatCrossThemselvesNamesAndWalls) {
  Map map = goodMap();
  Building bow = house("bow", 0.0, 0.0);
  bow.shape = Polygon{{60.0, 0.0}, {70.0, 10.0}, {70.0, 0.0}, {60.0, 10.0}};
  map.buildings.push_back(bow);
  map.buildings.push_back(house("wall", 90.0, 0.0, 0.4));
  map.buildings[0].name = map.buildings[1].name = "Library";
  map.landmarks = {{"gate", "Library", {0.0, -5.0}, {}}};
  EXPECT_EQ(kindsOf(map),
            (std::vector{Kind::CrossesItself, Kind::SameName, Kind::SameName, Kind::TooNarrow}));
}

TEST(Issues, ManyAreFoundInTimeAndBounded) {
  Map map;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 3000.0);
  for (int i = 0; i < 20'000; ++i)
    map.buildings.push_back(house(std::to_string(i), place(random), place(random)));
  EXPECT_EQ(findIssues(map).size(), kMaxIssues);
}

TEST(Issues, ASearchThatNobodyWaitsForEnds) {
  Map map;
  for (int i = 0; i < 1000; ++i) map.buildings.push_back(house(std::to_string(i), 20.0 * i, 0.0));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(findIssues(map, stop.get_token()), Error);
}

}  // namespace
}  // namespace handmap
