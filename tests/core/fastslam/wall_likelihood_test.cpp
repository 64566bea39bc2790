#include "core/fastslam/wall_likelihood.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/fastslam/direct_likelihood.h"

namespace handmap {
namespace {

Building rectangle(double x, double y, double width, double depth, double heading = 0.0) {
  Building building;
  building.id = "B";
  building.shape = Rectangle{{x, y}, width, depth, heading};
  return building;
}

Building lShape(double x, double y, double size, double heading) {
  Building building;
  building.id = "L";
  const Pose2 frame{x, y, heading};
  Polygon corners;
  for (const Vec2& corner :
       {Vec2(-1, -1), Vec2(1, -1), Vec2(1.2, 0), Vec2(0, 0), Vec2(-0.3, 1), Vec2(-1, 1)}) {
    corners.push_back(frame.toOuter(corner * size));
  }
  building.shape = corners;
  return building;
}

WallCells read(const BuildingModel& model, const Pose2& robot, const LineSums& sums,
               const BuildingState& state) {
  return WallLikelihood(model, robot, unitVector(robot.heading), sums)(
      static_cast<float>(state.x - model.drawn().x), static_cast<float>(state.y - model.drawn().y),
      static_cast<float>(state.width));
}

/// A smooth map with gaps: a wall read half a cell aside finds about the same.
LocalMap waves(double range_m) {
  LocalMap local_map(0.1, range_m);
  for (int row = 0; row < local_map.cells().rows; ++row) {
    for (int column = 0; column < local_map.cells().cols; ++column) {
      const double wave = std::sin(row * 0.031) * std::cos(column * 0.017);
      local_map.cells()(row, column) = static_cast<float>(std::max(0.0, wave));
    }
  }
  return local_map;
}

/// What reading every cell finds for the building where it is, half a cell beside, and turned by an
/// eighth of a degree.
struct Reach {
  WallCells least{1e9F, 1e9F, 1 << 30};
  WallCells most;

  Reach(Building building, const BuildingState& state, const Pose2& robot, const LocalMap& map) {
    const Rectangle box = building.box();
    for (const double turn : {-LineDirection::kStep / 2.0, 0.0, LineDirection::kStep / 2.0}) {
      const Rectangle turned{box.centre, box.width, box.depth, box.heading + turn};
      const BuildingModel model(building.fitted(turned));
      const test::DirectLikelihood walls(model, robot, map);
      for (const double x : {-0.05, 0.0, 0.05}) {
        for (const double y : {-0.05, 0.0, 0.05}) {
          const WallCells cells = walls({state.x + x, state.y + y, state.width});
          least = {std::min(least.sum, cells.sum), std::min(least.non_zero, cells.non_zero),
                   std::min(least.all, cells.all)};
          most = {std::max(most.sum, cells.sum), std::max(most.non_zero, cells.non_zero),
                  std::max(most.all, cells.all)};
        }
      }
    }
  }
};

TEST(WallLikelihood, AgreesWithReadingEveryCell) {
  RandomStream random(11);
  const LocalMap local_map = waves(20.0);
  LineSums sums;
  sums.reset(local_map);
  int hit = 0;
  double difference = 0.0;
  double all = 0.0;
  for (int trial = 0; trial < 5000; ++trial) {
    const double heading = random.uniform(-kPi, kPi);
    const Vec2 at(random.uniform(-25, 25), random.uniform(-25, 25));
    const Building building =
        trial % 3 == 0
            ? lShape(at.x(), at.y(), random.uniform(2, 12), heading)
            : rectangle(at.x(), at.y(), random.uniform(2, 30), random.uniform(2, 20), heading);
    const BuildingModel model(building);
    const Pose2 robot{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-kPi, kPi)};
    BuildingState state = model.drawn();
    state.x += random.normal(0.0, 3.0);
    state.y += random.normal(0.0, 3.0);
    state.width = std::max(1.0, state.width + random.normal(0.0, 3.0));
    const WallCells fast = read(model, robot, sums, state);
    const Reach plain(building, state, robot, local_map);
    // A wall or its part within range has two ends, each rounded to a cell, of up to six walls.
    // Where the map begins inside the four cells of an end, at most three are not as it thinks.
    constexpr int kEnds = 9;
    EXPECT_GE(fast.all, plain.least.all - kEnds) << trial;
    EXPECT_LE(fast.all, plain.most.all + kEnds) << trial;
    EXPECT_GE(fast.non_zero, plain.least.non_zero - kEnds) << trial;
    EXPECT_LE(fast.non_zero, plain.most.non_zero + kEnds) << trial;
    EXPECT_GE(fast.sum, plain.least.sum - kEnds) << trial;
    EXPECT_LE(fast.sum, plain.most.sum + kEnds) << trial;
    const WallCells exact = test::DirectLikelihood(model, robot, local_map)(state);
    difference += static_cast<double>(fast.sum - exact.sum);
    all += static_cast<double>(exact.sum);
    hit += exact.non_zero > 100;
  }
  EXPECT_GT(hit, 1000);
  EXPECT_NEAR(difference, 0.0, 2e-3 * all);  // rounding does not lean to one side
}

TEST(WallLikelihood, IsAllButExactWhereNothingIsRounded) {
  // Robot and walls along the axes, corners 0.03 m beside the corners of cells, all within range.
  const LocalMap local_map = waves(20.0);
  LineSums sums;
  sums.reset(local_map);
  RandomStream random(12);
  for (int trial = 0; trial < 200; ++trial) {
    const auto place = [&] { return 0.2 * (random.index(80) - 40) + 0.03; };
    const auto size = [&] { return 0.2 * (10 + random.index(30)); };
    const double heading = random.index(4) * kPi / 2.0;
    const double depth = size();
    const double width = size();
    const double y = place();
    const double x = place();
    const BuildingModel model(rectangle(x, y, width, depth, heading));
    const WallCells fast = read(model, {}, sums, model.drawn());
    const WallCells plain = test::DirectLikelihood(model, {}, local_map)(model.drawn());
    EXPECT_EQ(fast.all, plain.all) << trial;
    // Up to four ends inside four cells that are not alike.
    EXPECT_NEAR(fast.non_zero, plain.non_zero, 3.0) << trial;
    EXPECT_NEAR(fast.sum, plain.sum, 0.1) << trial;
  }
}

TEST(WallLikelihood, IsHighestWhereTheWallIs) {
  // A wall from x = -5 to 5 at y = 8, as a robot at the origin sees it.
  LocalMap local_map(0.1, 20.0);
  for (double x = -5.0; x < 5.0; x += 0.05) {
    local_map.cells()(local_map.columnOf(8.0), local_map.columnOf(x)) = 1.0F;
  }
  const BuildingModel model(rectangle(0.0, 12.0, 10.0, 8.0));
  LineSums sums;
  sums.reset(local_map);
  const auto score = [&](double x, double y, double width) {
    return discounted(read(model, {}, sums, {x, y, width}), EffectiveRatio::ToAll);
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
  LineSums sums;
  sums.reset(local_map);
  // Straight ahead and square to the robot: only the near wall of 6 m faces it.
  const BuildingModel near(rectangle(10.0, 0.0, 4.0, 6.0));
  EXPECT_NEAR(read(near, {}, sums, near.drawn()).all, 60, 1);
  const BuildingModel far(rectangle(40.0, 0.0, 4.0, 6.0));
  EXPECT_EQ(read(far, {}, sums, far.drawn()).all, 0);
}

TEST(EffectiveRatio, DiscountsTheSum) {
  const WallCells cells{6.0F, 30.0F, 40};
  EXPECT_FLOAT_EQ(discounted(cells, EffectiveRatio::ToAll), 6.0F * 30 / 40);
  EXPECT_FLOAT_EQ(discounted(cells, EffectiveRatio::ToZero), 6.0F * 30 / 10);
  EXPECT_FLOAT_EQ(discounted({6.0F, 40.0F, 40}, EffectiveRatio::ToZero), 6.0F * 40);
  EXPECT_FLOAT_EQ(discounted({}, EffectiveRatio::ToAll), 0.0F);
}

}  // namespace
}  // namespace handmap
