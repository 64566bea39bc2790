#include "core/localization/line_sums.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

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
    const cv::Rect spot(random.index(side), random.index(side), 1 + random.index(9), 1);
    local_map.cells()(spot & cv::Rect(0, 0, side, side)).setTo(0.5F);
  }
  return local_map;
}

/// The definition: cell by cell along the middle of a row, in the frame that is turned by
/// `steps` · kStep. Ends are rounded to cells.
LineCells plain(const LocalMap& map, float unit, int steps, int row, int first, int last) {
  const Pose2 turned{0.0, 0.0, steps * LineDirection::kStep};
  const int radius = static_cast<int>(map.range() / map.cell() - 1.0);
  LineCells cells;
  for (int i = first; i < last; ++i) {
    if (Vec2(i + 0.5, row + 0.5).norm() > radius) continue;
    const Vec2 p = turned.toOuter(Vec2(i + 0.5, row + 0.5) * map.cell());
    const float value = map.at(p.x(), p.y());
    cells.sum += static_cast<std::uint32_t>(value / unit + 0.5F);
    cells.non_zero += value > 0.0F;
    ++cells.all;
  }
  return cells;
}

void checkAgainstCells(const LocalMap& map) {
  LineSums sums;
  sums.reset(map);
  RandomStream random(10);
  int different = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const int steps = random.index(4 * LineDirection::kHalfTurn) - 2 * LineDirection::kHalfTurn;
    const int row = random.index(440) - 220;
    const int first = random.index(440) - 220;
    const int last = first + random.index(300);
    LineCells found;
    sums.add(LineDirection(steps), static_cast<float>(row) + 0.5F, static_cast<float>(first),
             static_cast<float>(last), found);
    const LineCells expected = plain(map, sums.unit(), steps, row, first, last);
    ASSERT_EQ(found.all, expected.all) << trial;
    // A place on the border of two cells may fall to either.
    different += found.sum != expected.sum || found.non_zero != expected.non_zero;
    ASSERT_NEAR(found.non_zero, expected.non_zero, 3) << trial;
  }
  EXPECT_LT(different, 100);
}

TEST(LineSums, AreWhatTheirCellsHold) { checkAgainstCells(speckled(20.0, 0)); }

TEST(LineSums, PassOverNothingThatIsThere) { checkAgainstCells(spotted(20.0)); }

TEST(LineSums, AlongTheAxesAreExact) {
  const LocalMap map = speckled(20.0, 1);
  LineSums sums;
  sums.reset(map);
  for (const int quarter : {-3, -2, -1, 0, 1, 2, 3, 4}) {
    const int steps = quarter * LineDirection::kHalfTurn / 2;
    for (int row = -190; row < 190; row += 7) {
      LineCells found;
      sums.add(LineDirection(steps), static_cast<float>(row) + 0.5F, -150.0F, 120.0F, found);
      const LineCells expected = plain(map, sums.unit(), steps, row, -150, 120);
      EXPECT_EQ(found.sum, expected.sum) << quarter << ' ' << row;
      EXPECT_EQ(found.non_zero, expected.non_zero);
      EXPECT_EQ(found.all, expected.all);
    }
  }
}

TEST(LineSums, ForgetTheMapBefore) {
  LineSums sums;
  for (const double range : {20.0, 20.0, 30.0, 12.3}) {
    const LocalMap map = speckled(range, static_cast<std::uint32_t>(range));
    sums.reset(map);
    LineCells found;
    sums.add(LineDirection(0), 5.5F, -90.0F, 90.0F, found);
    EXPECT_EQ(found.sum, plain(map, sums.unit(), 0, 5, -90, 90).sum) << range;
  }
}

TEST(LineSums, CountsFullRowsOfTheLargestMaps) {
  for (const double range : {10.0, 60.0, 200.0}) {
    LocalMap map(0.1, range);
    map.cells().setTo(1.0F);
    LineSums sums;
    sums.reset(map);
    LineCells found;
    sums.add(LineDirection(0), 0.5F, -1e9F, 1e9F, found);
    EXPECT_EQ(found.non_zero, found.all);
    EXPECT_NEAR(found.all, 20.0 * range, 5.0);
    EXPECT_NEAR(static_cast<float>(found.sum) * sums.unit(), found.all, 1e-3 * found.all);
  }
}

TEST(LineSums, OfNothingAndBesideTheMapAreNone) {
  const LocalMap map = speckled(20.0, 2);
  LineSums sums;
  sums.reset(map);
  const float infinite = std::numeric_limits<float>::infinity();
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (const float lateral : {-200.0F, 199.5F, 1e30F, -infinite, none}) {
    LineCells found;
    sums.add(LineDirection(7), lateral, -50.0F, 50.0F, found);
    EXPECT_EQ(found.all, 0) << lateral;
  }
  LineCells found;
  sums.add(LineDirection(7), 3.0F, 250.0F, 270.0F, found);
  EXPECT_EQ(found.all, 0);
}

TEST(LineSums, AreTheSameWhicheverThreadReadsFirst) {
  const LocalMap map = speckled(20.0, 3);
  const auto readAll = [&](bool parallel) {
    LineSums sums;
    sums.reset(map);
    std::vector<std::uint32_t> found(3000);
    const auto read = [&](std::size_t i) {
      LineCells cells;
      sums.add(LineDirection(static_cast<int>(i % 3)), static_cast<float>(i / 3 % 40), -80.0F,
               80.0F, cells);
      found[i] = cells.sum;
    };
    if (parallel) {
      tbb::parallel_for(std::size_t{0}, found.size(), read);
    } else {
      for (std::size_t i = 0; i < found.size(); ++i) read(i);
    }
    return found;
  };
  EXPECT_EQ(readAll(true), readAll(false));
}

}  // namespace
}  // namespace handmap
