#include "core/evaluation/common_shift.h"

#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace handmap {
namespace {

struct Made {
  Map drawing;
  Map refined;
};

/// Twenty buildings, all off by a shift and a turn, each by `own` more, and found as well as σ
/// says: one after the other, from a way that is off more and more.
Made made(std::uint64_t seed, const Vec2& shift, double turn, double own) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> place(-100.0, 100.0);
  Made maps;
  constexpr double kSight = 0.1;
  double before = kSight;
  Vec2 way = Vec2::Zero();
  for (int i = 0; i < 20; ++i) {
    const Vec2 at(place(random), place(random));
    const double sigma = kSight + 0.02 * i;
    const double step = std::sqrt(sigma * sigma - before * before);
    before = sigma;
    way += step * Vec2(normal(random), normal(random));
    const auto off = [&](double of_way) {
      return of_way + std::hypot(own, kSight) * normal(random);
    };
    Building building;
    building.id = fmt::format("B{}", i);
    building.shape = Rectangle{at, 10.0, 8.0, 0.0};
    maps.drawing.buildings.push_back(building);
    const Vec2 turned = Pose2{0.0, 0.0, turn}.toOuter(at);
    building.shape = Rectangle{turned + shift + Vec2(off(way.x()), off(way.y())), 10.0, 8.0, 0.0};
    building.estimate = Estimate{sigma, sigma, sigma, 5};
    maps.refined.buildings.push_back(building);
  }
  return maps;
}

TEST(CommonShift, IsFoundAsWellAsItSays) {
  int within = 0;
  int turns_within = 0;
  double own = 0.0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto [drawing, refined] = made(static_cast<std::uint64_t>(trial), {0.0, 0.0}, 0.0, 0.8);
    const auto common = commonShiftOf(drawing, refined);
    ASSERT_TRUE(common);
    within += std::abs(common->shift.x()) < common->shift_sigma.x() ? 1 : 0;
    turns_within += std::abs(common->turn) < common->turn_sigma ? 1 : 0;
    own += common->own / kTrials;
    EXPECT_LT(common->shift.norm(), 1.5);
  }
  EXPECT_GT(within, kTrials * 60 / 100);
  EXPECT_LT(within, kTrials * 75 / 100);
  EXPECT_GT(turns_within, kTrials * 60 / 100);
  EXPECT_LT(turns_within, kTrials * 75 / 100);
  EXPECT_NEAR(own, 0.8, 0.1);
}

TEST(CommonShift, IsAsSureAsTheStartOfTheRobot) {
  int within = 0;
  constexpr int kTrials = 400;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::mt19937_64 random(static_cast<std::uint64_t>(trial));
    std::normal_distribution<double> normal;
    auto [drawing, refined] = made(static_cast<std::uint64_t>(trial), {0.0, 0.0}, 0.0, 0.8);
    drawing.start = Pose2{-100.0, 0.0, 0.0};
    drawing.start_uncertainty = StartUncertainty{0.3, toRadians(0.5)};
    drawing.whole = {0.0, 0.0};
    const Pose2 way{0.3 * normal(random), 0.3 * normal(random), toRadians(0.5) * normal(random)};
    const Pose2 off = *drawing.start * way * inverse(*drawing.start);
    for (Building& building : refined.buildings) {
      auto& box = std::get<Rectangle>(building.shape);
      box.centre = off.toOuter(box.centre);
    }
    const auto common = commonShiftOf(drawing, refined);
    ASSERT_TRUE(common);
    within += std::abs(common->shift.x()) < common->shift_sigma.x() ? 1 : 0;
    within += std::abs(common->shift.y()) < common->shift_sigma.y() ? 1 : 0;
    EXPECT_LT(common->turn_sigma, toRadians(0.1));  // the drawing says that it is turned rightly
  }
  EXPECT_GT(within, 2 * kTrials * 60 / 100);
  EXPECT_LT(within, 2 * kTrials * 75 / 100);
}

TEST(CommonShift, TellsShiftAndTurnApart) {
  const auto [drawing, refined] = made(7, {5.0, -3.0}, 0.02, 0.5);
  const auto common = commonShiftOf(drawing, refined);
  ASSERT_TRUE(common);
  EXPECT_EQ(common->buildings, 20);
  EXPECT_NEAR(common->turn, 0.02, 0.005);
  EXPECT_NEAR(common->shift.norm(), std::hypot(5.0, 3.0), 1.0);
}

TEST(CommonShift, IsNotThatOfBuildingsThatWereTakenForOthers) {
  auto [drawing, refined] = made(7, {5.0, -3.0}, 0.0, 0.8);
  const auto right = commonShiftOf(drawing, refined);
  for (std::size_t i = 0; i < 4; ++i) {
    refined.buildings[i].shape =
        Rectangle{refined.buildings[i].box().centre + Vec2(-14.0, 9.0), 10.0, 8.0, 0.0};
  }
  const auto common = commonShiftOf(drawing, refined);
  ASSERT_TRUE(right && common);
  EXPECT_EQ(common->buildings, 16);
  EXPECT_LT((common->shift - right->shift).norm(), 0.5);
  EXPECT_LT(common->shift_sigma.maxCoeff(), 0.4);
}

TEST(CommonShift, NeedsThreeBuildingsThatWereSeen) {
  auto [drawing, refined] = made(7, {5.0, -3.0}, 0.0, 0.5);
  for (std::size_t i = 2; i < refined.buildings.size(); ++i) refined.buildings[i].estimate.reset();
  EXPECT_FALSE(commonShiftOf(drawing, refined));
}

}  // namespace
}  // namespace handmap
