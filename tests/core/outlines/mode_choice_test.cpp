#include "core/outlines/mode_choice.h"

#include <gtest/gtest.h>

#include "core/outlines/constants.h"

namespace handmap {
namespace {

using namespace outlines;

using Modes = std::vector<int>;

TEST(ModeChoice, TakesTheBestWhereNothingIsInConflict) {
  EXPECT_EQ(chooseModes({{3.0, 5.0}, {}, {2.0}}, {}), (Modes{1, kNoMode, 0}));
}

TEST(ModeChoice, NothingIsBetterThanWhatTheRaysSpeakAgainst) {
  EXPECT_EQ(chooseModes({{-3.0, -5.0}}, {}), Modes{kNoMode});
}

TEST(ModeChoice, ASurerOneMakesRoomWhereBothAreWorthMore) {
  EXPECT_EQ(chooseModes({{188.0, 125.0}, {97.0}}, {{0, 0, 1, 0, 97.0}}), (Modes{1, 0}));
  EXPECT_EQ(chooseModes({{188.0, 125.0}, {50.0}}, {{0, 0, 1, 0, 60.0}}), (Modes{0, kNoMode}));
}

TEST(ModeChoice, AConflictIsToldFromEitherSide) {
  EXPECT_EQ(chooseModes({{97.0}, {188.0, 125.0}}, {{0, 0, 1, 0, 97.0}}), (Modes{0, 1}));
}

TEST(ModeChoice, ARowOfThemMovesUpByOne) {
  // Each likes the place of the next one better; the last has another one.
  const std::vector<std::vector<double>> worth(4, {10.0, 9.0});
  std::vector<ModeConflict> conflicts;
  for (std::size_t i = 0; i < 3; ++i) conflicts.push_back({i, 0, i + 1, 1, 20.0});
  EXPECT_EQ(chooseModes(worth, conflicts), (Modes{0, 0, 0, 0}));
  conflicts.push_back({0, 0, 3, 0, 20.0});  // unless that is taken
  const Modes chosen = chooseModes(worth, conflicts);
  EXPECT_EQ(chosen, (Modes{1, 0, 0, 0}));
}

}  // namespace
}  // namespace handmap
