#include "core/simulation/world.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/simulation/route.h"

namespace handmap {
namespace {

Building box(const std::string& id, double x, double y, double width, double depth) {
  Building building;
  building.id = id;
  building.shape = Rectangle{{x, y}, width, depth, 0.0};
  return building;
}

/// Buildings clear of each other and of the route, trees clear of both.
void expectPossible(const World& world, double way_m) {
  const Map& map = world.map;
  const std::optional<Route> route = routeOf(map);
  ASSERT_TRUE(route);
  for (std::size_t i = 0; i < map.buildings.size(); ++i) {
    const Polygon footprint = map.buildings[i].footprint();
    EXPECT_TRUE(isSimple(footprint));
    EXPECT_GT(signedArea(footprint), 0.0);
    EXPECT_GT(route->distanceTo(footprint), way_m) << map.buildings[i].id;
    for (std::size_t j = i + 1; j < map.buildings.size(); ++j) {
      EXPECT_FALSE(overlap(footprint, map.buildings[j].footprint()));
    }
    for (const Obstacle& tree : world.obstacles) {
      EXPECT_GT(distanceTo(footprint, tree.centre), tree.radius);
    }
  }
  for (const Obstacle& tree : world.obstacles) {
    EXPECT_GT(std::abs(route->project(tree.centre).offset), tree.radius + 2.0);
  }
}

TEST(World, TwoRowsAreThePapersScene) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = twoRowWorld(seed);
    expectPossible(world, 5.0);
    EXPECT_EQ(*world.map.start, Pose2{});
    ASSERT_EQ(world.map.buildings.size(), 6U);
    EXPECT_FALSE(world.obstacles.empty());
    for (std::size_t i = 0; i < 6; ++i) {
      const Rectangle own = world.map.buildings[i].box();
      EXPECT_EQ(world.map.buildings[i].id, std::string(i < 3 ? "N" : "S") + char('1' + i % 3));
      EXPECT_EQ(own.centre.y() > 0.0, i < 3);
      EXPECT_GE(own.width, 45.0);
      EXPECT_LE(own.width, 65.0);
      if (i % 3 == 2) continue;
      const Rectangle next = world.map.buildings[i + 1].box();
      const double gap = next.centre.x() - own.centre.x() - (next.width + own.width) / 2.0;
      EXPECT_GE(gap, 15.0);
      EXPECT_LE(gap, 30.0);
    }
  }
}

TEST(World, CampusesAreVariedAndPossible) {
  int l_shaped = 0;
  int turned = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = campusWorld(seed);
    expectPossible(world, 6.0);
    EXPECT_GE(world.map.buildings.size(), 8U);
    EXPECT_GE(world.map.route.size(), 4U);
    const std::optional<Route> route = routeOf(world.map);
    bool left = false;
    bool right = false;
    for (const Building& building : world.map.buildings) {
      l_shaped += building.footprint().size() == 6 ? 1 : 0;
      turned += std::abs(std::sin(2.0 * building.box().heading)) > 0.1 ? 1 : 0;
      const bool on_left = route->project(building.box().centre).offset > 0.0;
      left = left || on_left;
      right = right || !on_left;
    }
    EXPECT_TRUE(left && right);
  }
  EXPECT_GT(l_shaped, 20);
  EXPECT_GT(turned, 100);
}

TEST(World, LoopsComeBackBetweenBuildingsOfEveryKind) {
  std::size_t courtyards = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const World world = loopWorld(seed);
    expectPossible(world, 4.0);
    const std::optional<Route> route = routeOf(world.map);
    EXPECT_GT(route->length(), 900.0);
    EXPECT_LT((route->poseAt(0.0).position() - world.map.route[4]).norm(), 1e-9);
    EXPECT_GE(world.map.buildings.size(), 30U);
    for (const Building& building : world.map.buildings) {
      courtyards += building.footprint().size() == 8 ? 1U : 0U;
    }
  }
  EXPECT_GT(courtyards, 20U);
}

/// Cars, hedges and the rest clear of buildings, trees, each other and the robot's way.
void expectClearThings(const World& world) {
  const std::optional<Route> route = routeOf(world.map);
  for (std::size_t i = 0; i < world.things.size(); ++i) {
    const Polygon own = world.things[i].footprint.corners();
    EXPECT_GT(route->distanceTo(own), 1.7);
    EXPECT_GT(world.things[i].height, 0.5);
    for (const Building& building : world.map.buildings) {
      EXPECT_FALSE(overlap(own, building.footprint()));
    }
    for (std::size_t j = i + 1; j < world.things.size(); ++j) {
      EXPECT_FALSE(overlap(own, world.things[j].footprint.corners()));
    }
    for (const Obstacle& tree : world.obstacles) {
      EXPECT_GT(distanceTo(own, tree.centre), tree.radius);
    }
  }
}

TEST(World, StreetsHaveHousesOnBothSides) {
  int bent = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = streetWorld(seed);
    expectPossible(world, 7.5);
    expectClearThings(world);
    const std::optional<Route> route = routeOf(world.map);
    const std::size_t houses = world.map.buildings.size();
    EXPECT_GE(houses, 12U);
    EXPECT_LE(houses, 18U);
    std::size_t left = 0;
    for (const Building& house : world.map.buildings) {
      const Rectangle own = house.box();
      EXPECT_GE(own.width, 8.0);
      EXPECT_LE(own.width, 20.0);
      const bool on_left = route->project(own.centre).offset > 0.0;
      EXPECT_EQ(house.id[0], on_left ? 'L' : 'R');
      left += on_left ? 1 : 0;
      const double front = route->distanceTo(house.footprint());
      EXPECT_GT(front, 4.0 + 3.5);
      EXPECT_LT(front, 4.0 + 8.5);
    }
    EXPECT_EQ(left, houses / 2);
    const Vec2 end = (world.map.route[2] - world.map.route[1]).normalized();
    bent += std::abs(end.y()) > 0.01 ? 1 : 0;
    EXPECT_LT(std::abs(end.y()), std::sin(toRadians(8.1)));
  }
  EXPECT_GT(bent, 5);
  EXPECT_LT(bent, 20);
}

TEST(World, FurnitureChangesNothingThatWasThere) {
  std::map<Thing::Kind, std::size_t> counts;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const World& bare : {twoRowWorld(seed), campusWorld(seed)}) {
      EXPECT_TRUE(bare.things.empty());
      const World full = furnished(bare, seed);
      EXPECT_EQ(full.map, bare.map);
      EXPECT_EQ(full.obstacles.size(), bare.obstacles.size());
      expectClearThings(full);
      for (const Thing& thing : full.things) ++counts[thing.kind];
    }
  }
  EXPECT_GT(counts[Thing::Kind::Car], 200U);
  EXPECT_GT(counts[Thing::Kind::Hedge], 30U);
  EXPECT_GT(counts[Thing::Kind::Lamp], 60U);
  EXPECT_GT(counts[Thing::Kind::Sign], 60U);
  EXPECT_GT(counts[Thing::Kind::Person], 150U);
}

TEST(World, TerracesStandWallToWallAndOneRowIsStepped) {
  int north_flush = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = terraceWorld(seed);
    const std::vector<Building>& houses = world.map.buildings;
    ASSERT_EQ(houses.size(), 12U);
    EXPECT_LT((world.map.route.back() - world.map.start->position()).norm(), 1e-9);
    for (const std::size_t row : {0U, 6U}) {
      std::vector<double> fronts;
      for (std::size_t i = row; i < row + 6; ++i) {
        const Rectangle house = houses[i].box();
        fronts.push_back(std::abs(house.centre.y()) - house.depth / 2.0);
        EXPECT_GE(routeOf(world.map)->distanceTo(houses[i].footprint()), 7.9);
        if (i == row) continue;
        const Rectangle before = houses[i - 1].box();
        EXPECT_NEAR(before.centre.x() + before.width / 2.0, house.centre.x() - house.width / 2.0,
                    1e-9);
      }
      const auto [low, high] = std::minmax_element(fronts.begin(), fronts.end());
      const bool flush = *high - *low < 1e-9;
      EXPECT_LE(*high - *low, 1.0);
      if (row == 0) north_flush += flush ? 1 : 0;
    }
    const Map drawn = perturbed(world.map, 3.0, seed);
    int moved = 0;
    for (std::size_t i = 0; i < houses.size(); ++i) {
      moved += (drawn.buildings[i].box().centre - houses[i].box().centre).norm() > 0.5 ? 1 : 0;
    }
    EXPECT_GE(moved, 8) << seed;
  }
  EXPECT_GT(north_flush, 4);
  EXPECT_LT(north_flush, 16);
}

TEST(World, ShedsAndCarsStandAlongTheFrontsAndNobodyDrawsTheSheds) {
  std::size_t sheds = 0;
  std::size_t cars = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const World& bare :
         {twoRowWorld(seed), campusWorld(seed), quarterWorld(seed), streetWorld(seed)}) {
      const World full = withSheds(bare, seed);
      EXPECT_EQ(full.drawable(), bare.map);
      EXPECT_EQ(full.walls.empty(), bare.walls.empty());
      const std::size_t houses = bare.map.buildings.size();
      for (std::size_t i = houses; i < full.map.buildings.size(); ++i) {
        const Polygon shed = full.wallsOf(i);
        EXPECT_LT(std::abs(signedArea(shed)), 22.0);
        EXPECT_GE(routeOf(full.map)->distanceTo(shed), 1.8);
        double to_house = 1e9;
        for (std::size_t k = 0; k < houses; ++k) {
          EXPECT_FALSE(overlap(shed, full.wallsOf(k)));
          for (const Vec2& corner : shed) {
            to_house = std::min(to_house, distanceTo(full.map.buildings[k].footprint(), corner));
          }
        }
        EXPECT_LT(to_house, 4.0);
        ++sheds;
      }
      cars += full.things.size() - bare.things.size();
    }
  }
  EXPECT_GT(sheds, 60U);
  EXPECT_GT(cars, 100U);
}

TEST(World, RoughnessIsWhatRealPlacesHave) {
  std::map<Thing::Kind, std::size_t> counts;
  std::size_t recesses = 0;
  std::size_t bays = 0;
  std::size_t soft = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const World& bare : {campusWorld(seed), streetWorld(seed), twoRowWorld(seed)}) {
      const World full = rough(bare, seed);
      EXPECT_EQ(full.map, bare.map);
      ASSERT_EQ(full.walls.size(), bare.map.buildings.size());
      const std::optional<Route> route = routeOf(full.map);
      for (std::size_t i = 0; i < full.walls.size(); ++i) {
        const Polygon drawn = bare.map.buildings[i].footprint();
        const Polygon walls = full.wallsOf(i);
        EXPECT_TRUE(isSimple(walls));
        EXPECT_GT(route->distanceTo(walls), 2.5);
        EXPECT_GT(intersectionOverUnion(walls, drawn), 0.8);
        for (const Vec2& corner : walls) {
          const bool inside = contains(drawn, corner) && distanceTo(drawn, corner) == 0.0;
          (inside ? recesses : bays) += 1;
        }
        for (const Thing& thing : full.things) {
          EXPECT_FALSE(overlap(walls, thing.footprint.corners()));
        }
        for (std::size_t j = i + 1; j < full.walls.size(); ++j) {
          EXPECT_FALSE(overlap(walls, full.walls[j]));
        }
      }
      for (const Thing& thing : full.things) {
        ++counts[thing.kind];
        EXPECT_GT(route->distanceTo(thing.footprint.corners()), 1.7);
        const bool lets_pass = thing.kind == Thing::Kind::Hedge ||
                               thing.kind == Thing::Kind::Fence || thing.kind == Thing::Kind::Rack;
        EXPECT_EQ(thing.free_path_m > 0.0, lets_pass);
      }
      for (const Obstacle& plant : full.obstacles) {
        EXPECT_EQ(plant.free_path_m > 0.0, plant.radius >= Obstacle::kBush_m);
        soft += plant.free_path_m > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(recesses, 500U);
  EXPECT_GT(bays, 200U);
  EXPECT_GT(soft, 50U);
  EXPECT_GT(counts[Thing::Kind::Fence], 200U);
  EXPECT_GT(counts[Thing::Kind::Rack], 30U);
  EXPECT_GT(counts[Thing::Kind::Hedge], 300U);
  EXPECT_GT(counts[Thing::Kind::Car], 50U);  // of the streets
}

TEST(World, QuartersAreRoughAndTheirFrontsNearAndFar) {
  double nearest = 1e9;
  double farthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const World world = quarterWorld(seed);
    expectPossible(world, 3.5);
    EXPECT_GE(world.map.buildings.size(), 25U);
    EXPECT_EQ(world.walls.size(), world.map.buildings.size());
    const std::optional<Route> route = routeOf(world.map);
    for (const Building& building : world.map.buildings) {
      const double front = route->distanceTo(building.footprint());
      nearest = std::min(nearest, front);
      farthest = std::max(farthest, front);
    }
  }
  EXPECT_LT(nearest, 6.0);
  EXPECT_GT(farthest, 28.0);
}

TEST(World, FollowsFromItsSeed) {
  EXPECT_EQ(quarterWorld(7).walls, quarterWorld(7).walls);
  EXPECT_NE(quarterWorld(7).walls, quarterWorld(8).walls);
  EXPECT_EQ(twoRowWorld(7).map, twoRowWorld(7).map);
  EXPECT_NE(twoRowWorld(7).map.buildings, twoRowWorld(8).map.buildings);
  EXPECT_EQ(campusWorld(7).map, campusWorld(7).map);
}

TEST(World, FromAMapKeepsWhatIsDrawn) {
  Map map;
  map.buildings = {box("A", 50, 20, 40, 10), box("B", 80, -20, 40, 10)};
  EXPECT_THROW(worldFromMap(map, 1), Error);
  map.start = Pose2{};
  const World straight = worldFromMap(map, 1);
  EXPECT_EQ(straight.map.buildings, map.buildings);
  EXPECT_EQ(straight.map.route, (std::vector<Vec2>{{0, 0}, {100, 0}}));
  expectPossible(straight, 5.0);

  map.start.reset();
  map.route = {{0, 0}, {0, 30}};
  EXPECT_DOUBLE_EQ(worldFromMap(map, 1).map.start->heading, kPi / 2.0);
}

TEST(World, FromAMapRefusesAnEndlessRoute) {
  Map map;
  map.route = {{0, 0}, {1e6, 0}};
  EXPECT_THROW(worldFromMap(map, 1), Error);
}

TEST(World, FromAMapRefusesARouteThroughABuilding) {
  Map map;
  map.buildings = {box("A", 50, 0, 40, 10)};
  map.route = {{0, 0}, {100, 0}};
  try {
    worldFromMap(map, 1);
    FAIL() << "expected an error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadInput);
    EXPECT_NE(std::string(error.what()).find("building A"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace handmap
