#include "core/fastslam/line_sums.h"

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/random.h"

namespace handmap {
namespace {

/// Values of which a tenth is not 0, in whole thousandths.
LocalMap speckled(double range_m, std::uint32_t seed) {
  LocalMap local_map(0.1, range_m);
  RandomStream random(9, seed);
  for (float& value : local_map.cells()) {
    value = random.uniform() < 0.1 ? static_cast<float>(1 + random.index(1000)) * 1e-3F : 0.0F;
  }
  return local_map;
}

/// A few small spots in an empty map, up to its edge.
LocalMap spotted(double range_m) {
  LocalMap local_map(0.1, range_m);
  RandomStream random(9, 1000);
  const int side = local_map.cells().cols;
  for (int i = 0; i < 60; ++i) {
    const int length = 1 + random.index(9);
    const int row = random.index(side);
    const int column = random.index(side);
    const cv::Rect spot(column, row, length, 1);
    local_map.cells()(spot & cv::Rect(0, 0, side, side)).setTo(0.5F);
  }
  return local_map;
}

/// The definition: cell by cell along the middle of a row, in the frame that is turned by
/// `steps` · kStep.
WallCells plain(const LocalMap& map, int steps, int row, int first, int last) {
  const Pose2 turned{0.0, 0.0, steps * LineDirection::kStep};
  const double radius = std::floor(map.range() / map.cell() - 1.0);
  WallCells cells;
  if (std::abs(row + 0.5) > radius) return cells;
  // A row is as long as the circle of the range allows, to an even number of cells either way.
  const double reach = std::sqrt(radius * radius - (row + 0.5) * (row + 0.5));
  const int half = 2 * static_cast<int>(std::lround(reach / 2.0));
  for (int i = std::max(first, -half); i < std::min(last, half); ++i) {
    const Vec2 p = turned.toOuter(Vec2(i + 0.5, row + 0.5) * map.cell());
    const float value = map.at(p.x(), p.y());
    cells.sum += value;
    cells.non_zero += static_cast<float>(value > 0.0F);
    ++cells.all;
  }
  return cells;
}

WallCells read(const LineSums& sums, int steps, int row, int first, int last) {
  WallCells cells;
  sums.add(LineDirection(steps), static_cast<float>(row) + 0.5F, static_cast<float>(first),
           static_cast<float>(last), cells);
  return cells;
}

void checkAgainstCells(const LocalMap& map) {
  LineSums sums;
  sums.reset(map);
  RandomStream random(10);
  double difference = 0.0;
  double all = 0.0;
  for (int trial = 0; trial < 1000; ++trial) {
    const int steps = random.index(4 * LineDirection::kHalfTurn) - 2 * LineDirection::kHalfTurn;
    const int row = random.index(440) - 220;
    const int first = random.index(440) - 220;
    const int last = first + random.index(300);
    const WallCells found = read(sums, steps, row, first, last);
    const WallCells expected = plain(map, steps, row, first, last);
    ASSERT_EQ(found.all, expected.all) << trial;
    // At either end up to three cells count as if they were as the fourth. A place on the border
    // of two cells may fall to either.
    ASSERT_NEAR(found.non_zero, expected.non_zero, 4.0) << trial;
    ASSERT_NEAR(found.sum, expected.sum, 3.0) << trial;
    difference += static_cast<double>(found.sum - expected.sum);
    all += static_cast<double>(expected.sum);
  }
  EXPECT_NEAR(difference, 0.0, 0.01 * all);
}

TEST(LineSums, AreWhatTheirCellsHold) { checkAgainstCells(speckled(20.0, 0)); }

TEST(LineSums, PassOverNothingThatIsThere) { checkAgainstCells(spotted(20.0)); }

TEST(LineSums, BetweenTheirEntriesAreExact) {
  // Whole rows along the axes: no end is inside a stretch, no cell on a border.
  const LocalMap map = speckled(20.0, 1);
  LineSums sums;
  sums.reset(map);
  for (const int quarter : {-3, -2, -1, 0, 1, 2, 3, 4}) {
    for (int row = -190; row < 190; row += 7) {
      const WallCells found = read(sums, quarter * LineDirection::kHalfTurn / 2, row, -300, 300);
      const WallCells expected = plain(map, quarter * LineDirection::kHalfTurn / 2, row, -300, 300);
      EXPECT_EQ(found.non_zero, expected.non_zero) << quarter << ' ' << row;
      EXPECT_EQ(found.all, expected.all);
      EXPECT_NEAR(found.sum, expected.sum, 0.5F * sums.unit() * expected.non_zero + 1e-3F);
    }
  }
}

TEST(LineSums, ForgetTheMapBefore) {
  LineSums sums;
  for (const double range : {20.0, 20.0, 30.0, 12.3}) {
    const LocalMap map = speckled(range, static_cast<std::uint32_t>(range));
    sums.reset(map);
    const WallCells found = read(sums, 0, 5, -500, 500);
    const WallCells expected = plain(map, 0, 5, -500, 500);
    EXPECT_EQ(found.non_zero, expected.non_zero) << range;
    EXPECT_NEAR(found.sum, expected.sum, 0.01) << range;
  }
}

TEST(LineSums, CountsFullRowsOfLargeMaps) {
  for (const double range : {10.0, 60.0, 200.0}) {
    LocalMap map(0.1, range);
    map.cells().setTo(1.0F);
    LineSums sums;
    sums.reset(map);
    WallCells found;
    sums.add(LineDirection(0), 0.5F, -1e9F, 1e9F, found);
    EXPECT_EQ(found.non_zero, static_cast<float>(found.all));
    EXPECT_NEAR(found.all, 20.0 * range, 5.0);
    EXPECT_NEAR(found.sum, found.all, 1e-3 * found.all);
  }
}

TEST(LineSums, OfNothingAndBesideTheMapAreNone) {
  const LocalMap map = speckled(20.0, 2);
  LineSums sums;
  sums.reset(map);
  const float infinite = std::numeric_limits<float>::infinity();
  const float none = std::numeric_limits<float>::quiet_NaN();
  WallCells found;
  for (const float lateral : {-200.0F, 199.5F, 1e30F, -infinite, none}) {
    sums.add(LineDirection(7), lateral, -50.0F, 50.0F, found);
  }
  sums.add(LineDirection(7), 3.0F, none, none, found);
  sums.add(LineDirection(7), 3.0F, 250.0F, 270.0F, found);
  EXPECT_EQ(found.all, 0);
  EXPECT_EQ(found.sum, 0.0F);
}

TEST(LineSums, AreTheSameWhicheverThreadReadsFirst) {
  const LocalMap map = speckled(20.0, 3);
  const auto read_all = [&](bool parallel) {
    LineSums sums;
    sums.reset(map);
    std::vector<float> found(3000);
    const auto one = [&](std::size_t i) {
      found[i] = read(sums, static_cast<int>(i % 3), static_cast<int>(i / 3 % 40), -80, 80).sum;
    };
    if (parallel) {
      parallelFor(found.size(), one);
    } else {
      for (std::size_t i = 0; i < found.size(); ++i) one(i);
    }
    return found;
  };
  EXPECT_EQ(read_all(true), read_all(false));
}

}  // namespace
}  // namespace handmap
