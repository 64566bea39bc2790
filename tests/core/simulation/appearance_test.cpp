#include "core/simulation/appearance.h"

#include <set>

#include <gtest/gtest.h>

namespace handmap {
namespace {

TEST(Appearance, IsThatOfHousesOrOfLargeBuildings) {
  std::set<int> storeys;
  std::set<Appearance::Finish> finishes;
  std::set<float> reds;
  int pitched = 0;
  int houses = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const World street = streetWorld(seed);
    for (std::size_t i = 0; i < street.map.buildings.size(); ++i) {
      const Appearance look = appearanceOf(street, i);
      ++houses;
      pitched += look.roof == Appearance::Roof::Flat ? 0 : 1;
      storeys.insert(look.storeys);
      finishes.insert(look.finish);
      reds.insert(look.wall[0]);
      EXPECT_GT(look.eaves_m(), 2.9);
      EXPECT_LT(look.eaves_m(), 10.5);
      EXPECT_LT(look.window_width_m, look.bay_m);
      EXPECT_LT(look.sill_m + look.window_height_m, look.storey_m + 0.3);
      for (const float share : look.wall) {
        EXPECT_GE(share, 0.02F);
        EXPECT_LE(share, 0.85F);
      }
    }
    const World rows = twoRowWorld(seed);
    EXPECT_GE(appearanceOf(rows, 0).storeys, 2);
  }
  EXPECT_GT(pitched, houses * 3 / 4);
  EXPECT_LT(pitched, houses);
  EXPECT_EQ(storeys, (std::set{1, 2, 3}));
  EXPECT_EQ(finishes.size(), 2U);
  EXPECT_EQ(reds.size(), static_cast<std::size_t>(houses));  // no two alike
}

TEST(Appearance, FollowsFromTheSeedOfTheWorld) {
  World world = twoRowWorld(1);
  const Appearance first = appearanceOf(world, 0);
  EXPECT_EQ(first.wall, appearanceOf(world, 0).wall);
  EXPECT_NE(first.wall, appearanceOf(world, 1).wall);
  world.seed = 2;
  EXPECT_NE(first.wall, appearanceOf(world, 0).wall);
}

TEST(Appearance, APolygonHasAFlatRoof) {
  World world;
  Building building;
  building.id = "P";
  building.shape = Polygon{{0, 0}, {9, 0}, {9, 4}, {5, 4}, {5, 8}, {0, 8}};
  world.map.buildings = {building};
  for (world.seed = 1; world.seed < 20; ++world.seed) {
    EXPECT_EQ(appearanceOf(world, 0).roof, Appearance::Roof::Flat);
  }
}

}  // namespace
}  // namespace handmap
