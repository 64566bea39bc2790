#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/simulation/route.h"
#include "core/simulation/world.h"

namespace handmap {
namespace {

void expectPossible(const Map& drawn, const Map& truth) {
  const std::optional<Route> route = routeOf(truth);
  ASSERT_EQ(drawn.buildings.size(), truth.buildings.size());
  for (std::size_t i = 0; i < drawn.buildings.size(); ++i) {
    const Polygon footprint = drawn.buildings[i].footprint();
    const Rectangle box = drawn.buildings[i].box();
    EXPECT_GE(std::min(box.width, box.depth), 3.0);
    EXPECT_GT(route->distanceTo(footprint), 1.0);
    EXPECT_GT(
        route->project(box.centre).offset * route->project(truth.buildings[i].box().centre).offset,
        0.0);
    for (std::size_t j = i + 1; j < drawn.buildings.size(); ++j) {
      EXPECT_FALSE(overlap(footprint, drawn.buildings[j].footprint()));
    }
  }
}

TEST(Perturbed, IsPossibleAndKeepsTheRows) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    for (const double sigma : {1.0, 5.0, 15.0}) {
      const Map truth = twoRowWorld(seed).map;
      const Map drawn = perturbed(truth, sigma, seed);
      expectPossible(drawn, truth);
      for (const std::size_t row : {0U, 3U}) {
        EXPECT_LT(drawn.buildings[row].box().centre.x(), drawn.buildings[row + 1].box().centre.x());
        EXPECT_LT(drawn.buildings[row + 1].box().centre.x(),
                  drawn.buildings[row + 2].box().centre.x());
      }
    }
    expectPossible(perturbed(campusWorld(seed).map, 5.0, seed), campusWorld(seed).map);
  }
}

TEST(Perturbed, ErrorsHaveTheWantedSpread) {
  double squares_x = 0.0;
  double squares_width = 0.0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Map truth = twoRowWorld(seed).map;
    const Map drawn = perturbed(truth, 2.0, seed);
    for (std::size_t i = 0; i < truth.buildings.size(); ++i) {
      const Rectangle a = drawn.buildings[i].box();
      const Rectangle b = truth.buildings[i].box();
      squares_x += (a.centre - b.centre).squaredNorm() / 2.0;
      squares_width += (a.width - b.width) * (a.width - b.width);
      ++count;
    }
  }
  EXPECT_NEAR(std::sqrt(squares_x / count), 2.0, 0.2);
  EXPECT_NEAR(std::sqrt(squares_width / count), 2.0, 0.2);
}

TEST(Perturbed, FollowsFromItsSeedAndTellsItsUncertainty) {
  Map truth = twoRowWorld(1).map;
  truth.buildings[0].fixed = true;
  const Map drawn = perturbed(truth, 5.0, 3);
  EXPECT_EQ(drawn, perturbed(truth, 5.0, 3));
  EXPECT_NE(drawn.buildings, perturbed(truth, 5.0, 4).buildings);
  EXPECT_EQ(drawn.buildings[0], truth.buildings[0]);
  EXPECT_EQ(drawn.uncertainty, (Uncertainty{5.0, 5.0}));
  EXPECT_EQ(drawn.start, truth.start);
}

TEST(Perturbed, NeedNotKeepSideAndOrder) {
  int crossed = 0;
  int swapped = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Map truth = twoRowWorld(seed).map;
    const Map drawn = perturbed(truth, 40.0, seed, Keeping::Nothing);
    for (std::size_t i = 0; i < truth.buildings.size(); ++i) {
      const Vec2 centre = drawn.buildings[i].box().centre;
      crossed += centre.y() * truth.buildings[i].box().centre.y() < 0.0;
      if (i % 3 != 0) swapped += centre.x() < drawn.buildings[i - 1].box().centre.x();
      EXPECT_GT(routeOf(truth)->distanceTo(drawn.buildings[i].footprint()), 1.0);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_FALSE(overlap(drawn.buildings[i].footprint(), drawn.buildings[j].footprint()));
      }
    }
  }
  EXPECT_GT(crossed, 0);
  EXPECT_GT(swapped, 0);
}

TEST(Perturbed, NeedsNoRoute) {
  Map truth = twoRowWorld(1).map;
  truth.route.clear();
  truth.start.reset();
  const Map drawn = perturbed(truth, 2.0, 1);
  EXPECT_NE(drawn.buildings, truth.buildings);
  for (std::size_t i = 0; i < drawn.buildings.size(); ++i) {
    for (std::size_t j = i + 1; j < drawn.buildings.size(); ++j) {
      EXPECT_FALSE(overlap(drawn.buildings[i].footprint(), drawn.buildings[j].footprint()));
    }
  }
}

TEST(Perturbed, RefusesCities) {
  Map truth;
  truth.buildings.resize(5001, twoRowWorld(1).map.buildings.front());
  EXPECT_THROW(perturbed(truth, 2.0, 1), Error);
}

}  // namespace
}  // namespace handmap
