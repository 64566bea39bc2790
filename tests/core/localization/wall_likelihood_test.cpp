#include "core/localization/wall_likelihood.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

Building rectangle(double x, double y, double width, double depth, double heading = 0.0) {
  Building building;
  building.id = "B";
  building.shape = Rectangle{{x, y}, width, depth, heading};
  return building;
}

/// Walls as the definition says, cell by cell, in doubles and in the map frame.
WallCells reference(const Polygon& footprint, const Pose2& robot, const LocalMap& local_map) {
  WallCells cells;
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Vec2 a = footprint[i];
    const Vec2 b = footprint[(i + 1) % footprint.size()];
    const Vec2 outward = -perpendicular(b - a);
    if ((robot.position() - a).dot(outward) <= 0.0) continue;
    const double length = (b - a).norm();
    for (double s = local_map.cell() / 2.0; s < length; s += local_map.cell()) {
      const Vec2 p = robot.toOwn(a + (b - a) / length * s);
      if (p.norm() > local_map.range() - local_map.cell()) continue;
      const float value = local_map.at(p.x(), p.y());
      cells.sum += value;
      cells.non_zero += value > 0.0F;
      ++cells.all;
    }
  }
  return cells;
}

TEST(WallLikelihood, AgreesWithThePlainDefinitionOnRandomCases) {
  RandomStream random(11);
  LocalMap local_map(0.1, 20.0);
  // Smooth values, so that a step that falls a hair beside a cell border changes little.
  for (int row = 0; row < local_map.cells().rows; ++row) {
    for (int column = 0; column < local_map.cells().cols; ++column) {
      const double wave = std::sin(row * 0.031) * std::cos(column * 0.017);
      local_map.cells()(row, column) = static_cast<float>(std::max(0.0, wave));
    }
  }
  for (int trial = 0; trial < 500; ++trial) {
    const Building building =
        rectangle(random.uniform(-25, 25), random.uniform(-25, 25), random.uniform(2, 30),
                  random.uniform(2, 20), random.uniform(-kPi, kPi));
    const Pose2 robot{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-kPi, kPi)};
    const BuildingModel model(building);
    const WallCells fast = WallLikelihood(model, robot, local_map)(model.drawn());
    const WallCells plain = reference(building.footprint(), robot, local_map);
    EXPECT_NEAR(fast.all, plain.all, 4);
    EXPECT_NEAR(fast.non_zero, plain.non_zero, 6);
    EXPECT_NEAR(fast.sum, plain.sum, 1.5 + 0.01 * plain.sum);  // an end cell of either wall
  }
}

TEST(WallLikelihood, IsHighestWhereTheWallIs) {
  // A wall from x = -5 to 5 at y = 8, as a robot at the origin sees it.
  LocalMap local_map(0.1, 20.0);
  for (double x = -5.0; x < 5.0; x += 0.05) {
    local_map.cells()(local_map.columnOf(8.0), local_map.columnOf(x)) = 1.0F;
  }
  const BuildingModel model(rectangle(0.0, 12.0, 10.0, 8.0));
  const WallLikelihood walls(model, {}, local_map);
  const auto score = [&](double x, double y, double width) {
    return discounted(walls({x, y, width}), EffectiveRatio::ToAll);
  };
  const double best = score(0.0, 12.05, 10.0);
  EXPECT_GT(best, 90.0);
  EXPECT_GT(best, score(1.0, 12.05, 10.0));
  EXPECT_GT(best, score(0.0, 13.0, 10.0));
  EXPECT_GT(best, score(0.0, 12.05, 11.0));
  EXPECT_GT(best, score(0.0, 12.05, 9.0));
}

TEST(WallLikelihood, WallsThatFaceAwayOrAreOutOfRangeDoNotCount) {
  LocalMap local_map(0.1, 20.0);
  local_map.cells().setTo(1.0F);
  // Straight ahead and square to the robot: only the near wall of 6 m faces it.
  const BuildingModel near(rectangle(10.0, 0.0, 4.0, 6.0));
  EXPECT_NEAR(WallLikelihood(near, {}, local_map)(near.drawn()).all, 60, 1);
  const BuildingModel far(rectangle(40.0, 0.0, 4.0, 6.0));
  EXPECT_EQ(WallLikelihood(far, {}, local_map)(far.drawn()).all, 0);
}

TEST(EffectiveRatio, DiscountsTheSum) {
  const WallCells cells{6.0, 30, 40};
  EXPECT_DOUBLE_EQ(discounted(cells, EffectiveRatio::ToAll), 6.0 * 30 / 40);
  EXPECT_DOUBLE_EQ(discounted(cells, EffectiveRatio::ToZero), 6.0 * 30 / 10);
  EXPECT_DOUBLE_EQ(discounted({6.0, 40, 40}, EffectiveRatio::ToZero), 6.0 * 40);
  EXPECT_DOUBLE_EQ(discounted({}, EffectiveRatio::ToAll), 0.0);
}

}  // namespace
}  // namespace handmap
