#include "core/outlines/agreement.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/map/certainty.h"

namespace handmap {
namespace {

constexpr double kStart_m = 0.3;
constexpr double kStartTurn = toRadians(1.0);

Map sixHouses() {
  Map map;
  map.start = Pose2{};
  for (int i = 0; i < 6; ++i) {
    Building house;
    house.id = std::string(1, static_cast<char>('A' + i));
    house.shape = Rectangle{{20.0 * i + 10.0, i % 2 == 0 ? 15.0 : -15.0}, 12.0, 8.0, 0.0};
    map.buildings.push_back(house);
  }
  return map;
}

/// As a run leaves a building that was seen from the way between the rows.
void see(Building& house) {
  house.estimate = Estimate{0.2, 0.2, 0.3, 20};
  const bool upper = house.box().centre.y() > 0.0;
  setSides(house, {SideEstimate{0.3, true}, {0.25, !upper}, {0.3, true}, {0.25, upper}});
}

void shift(Building& house, const Vec2& by) {
  auto& box = std::get<Rectangle>(house.shape);
  box.centre += by;
}

TEST(Agreement, FindsThatADrawingIsRight) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  RandomStream random(3);
  for (Building& house : fitted.buildings) {
    see(house);
    shift(house, {random.normal(0.0, 0.2), random.normal(0.0, 0.2)});
  }
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  for (std::size_t b = 0; b < 6; ++b) EXPECT_TRUE(agreement.isRight(b)) << b;
  EXPECT_LT(agreement.motion.position().norm(), 0.3);
}

TEST(Agreement, TakesAHouseThatWasMisfittedForRightWhereTheOthersAre) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  for (Building& house : fitted.buildings) see(house);
  shift(fitted.buildings[2], {0.0, 1.5});  // the hedge behind it
  EXPECT_TRUE(agreementOf(drawing, fitted, kStart_m, kStartTurn).isRight(2));
}

TEST(Agreement, LeavesADrawingFromMemoryToTheRays) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  RandomStream random(5);
  for (Building& house : fitted.buildings) {
    see(house);
    shift(house, {random.normal(0.0, 3.0), random.normal(0.0, 3.0)});
  }
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  for (std::size_t b = 0; b < 6; ++b) EXPECT_FALSE(agreement.isRight(b)) << b;
  EXPECT_EQ(agreement.motion, Pose2{});
}

/// Of many that are off some agree by chance, the more so if the start is moved for them.
TEST(Agreement, DoesNotTakeForRightWhatAgreesByChance) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Map drawing;
    drawing.start = Pose2{};
    Map fitted;
    RandomStream random(seed);
    for (int i = 0; i < 14; ++i) {
      Building house;
      house.id = std::to_string(i);
      house.shape = Rectangle{{20.0 * i + 10.0, i % 2 == 0 ? 15.0 : -15.0}, 12.0, 8.0, 0.0};
      drawing.buildings.push_back(house);
      see(house);
      Sides sides = sidesOf(house);
      sides[2].seen = false;  // two sides of each
      setSides(house, sides);
      const double x = random.normal(0.0, 2.0);
      shift(house, {x, random.normal(0.0, 2.0)});
      fitted.buildings.push_back(house);
    }
    const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
    for (std::size_t b = 0; b < 14; ++b) EXPECT_FALSE(agreement.isRight(b)) << seed << ' ' << b;
    EXPECT_EQ(agreement.motion, Pose2{}) << seed;
  }
}

TEST(Agreement, AStartThatIsStatedToBeOffIsPulledRightByAllBuildings) {
  Map drawing = sixHouses();
  drawing.uncertainty = {1.0, 1.0};
  drawing.start_uncertainty = StartUncertainty{2.0, toRadians(5.0)};
  const Pose2 off{-1.5, 1.2, toRadians(5.0)};
  Map fitted = drawing;
  RandomStream random(11);
  for (Building& house : fitted.buildings) {
    see(house);
    shift(house, {random.normal(0.0, 1.0), random.normal(0.0, 1.0)});
    auto& box = std::get<Rectangle>(house.shape);
    box.centre = off.toOuter(box.centre);
    box.heading += off.heading;
  }
  const StartUncertainty& start = *drawing.start_uncertainty;
  const Agreement agreement = agreementOf(drawing, fitted, start.position, start.heading);
  EXPECT_NEAR(agreement.motion.heading, off.heading, toRadians(1.1));
  for (const Building& house : drawing.buildings) {
    const Vec2 centre = house.box().centre;
    const double left = (agreement.motion.toOuter(centre) - off.toOuter(centre)).norm();
    EXPECT_LT(left, 3.0 * agreement.sigmaAt(centre)) << house.id;
    EXPECT_LT(left, 1.5) << house.id;
  }
}

TEST(Agreement, AStartThatIsKnownHoldsTheWayWhereAllIsDrawnOffTogether) {
  Map drawing = sixHouses();
  drawing.uncertainty = {1.3, 0.5};
  drawing.whole = {0.0, 0.0, 6.0};
  drawing.start_uncertainty = StartUncertainty{0.2, toRadians(0.5)};
  Map fitted = drawing;
  RandomStream random(13);
  for (Building& house : fitted.buildings) {
    see(house);
    shift(house, {-6.0 + random.normal(0.0, 1.0), 4.0 + random.normal(0.0, 1.0)});
  }
  const StartUncertainty& start = *drawing.start_uncertainty;
  const Agreement agreement = agreementOf(drawing, fitted, start.position, start.heading);
  EXPECT_LT(agreement.motion.toOuter({0.0, 0.0}).norm(), start.position);
  EXPECT_LT(std::abs(agreement.motion.heading), start.heading);
  for (std::size_t b = 0; b < 6; ++b) EXPECT_FALSE(agreement.isRight(b)) << b;
}

/// Six houses, each drawn 2 m off, seen along a way that is turned about its start by 2° (σ): how
/// far what they say of it is off, and times what is said of that, rms of twenty.
struct OfTurn {
  double off = 0.0;
  double times_said = 0.0;
};

OfTurn toldOfTheTurn(double way_turn, const std::optional<StartUncertainty>& start) {
  OfTurn told;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed);
    Map drawing = sixHouses();
    drawing.uncertainty = {2.0, 1.0};
    drawing.start_uncertainty = start;
    const Pose2 turned{0.0, 0.0, random.normal(0.0, way_turn)};
    Map fitted = drawing;
    for (Building& house : fitted.buildings) {
      see(house);
      const double x = random.normal(0.0, 2.0);
      shift(house, {x, random.normal(0.0, 2.0)});
      auto& box = std::get<Rectangle>(house.shape);
      box.centre = turned.toOuter(box.centre);
      box.heading += turned.heading;
    }
    const StartUncertainty known = start.value_or(StartUncertainty{kStart_m, kStartTurn});
    const Agreement agreement =
        agreementOf(drawing, fitted, known.position, known.heading, way_turn);
    EXPECT_FALSE(agreement.refutes_start) << seed;
    const double left = agreement.motion.heading - turned.heading;
    const double said = start ? std::sqrt(agreement.covariance(2, 2)) : agreement.way_turn;
    told.off += left * left / 20.0;
    told.times_said += std::pow(left / said, 2) / 20.0;
    EXPECT_LT(said, 0.8 * way_turn) << seed;
    EXPECT_LT(agreement.motion.position().norm(), start ? 0.3 : 1e-9) << seed;
  }
  return {std::sqrt(told.off), std::sqrt(told.times_said)};
}

TEST(Agreement, AWayThatMayBeTurnedIsTurnedAsAllBuildingsSay) {
  const double way_turn = toRadians(2.0);
  for (const auto& start :
       {std::optional<StartUncertainty>(), std::optional(StartUncertainty{0.1, toRadians(0.1)})}) {
    const OfTurn told = toldOfTheTurn(way_turn, start);
    EXPECT_LT(told.times_said, 1.5) << start.has_value();
    EXPECT_LT(told.off, 0.7 * way_turn) << start.has_value();
  }
}

TEST(Agreement, FindsTheOneHouseThatIsDrawnWrong) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  for (Building& house : fitted.buildings) see(house);
  shift(fitted.buildings[1], {-9.0, 7.0});
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  for (std::size_t b = 0; b < 6; ++b) EXPECT_EQ(agreement.isRight(b), b != 1) << b;
}

TEST(Agreement, FindsHowTheWayLiesOnADrawingThatIsRight) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  const Pose2 turned{0.1, -0.1, toRadians(0.8)};
  for (Building& house : fitted.buildings) {
    auto& box = std::get<Rectangle>(house.shape);
    box.centre = turned.toOuter(box.centre);
    box.heading += turned.heading;
    see(house);
  }
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  for (std::size_t b = 0; b < 6; ++b) EXPECT_TRUE(agreement.isRight(b)) << b;
  EXPECT_NEAR(agreement.motion.heading, turned.heading, toRadians(0.15));
}

TEST(Agreement, AllTogetherRefuteAStartOfWhichNothingIsSaid) {
  Map drawing = sixHouses();
  drawing.uncertainty = {2.0, 1.0};
  const Pose2 off{4.0, -3.0, toRadians(6.0)};
  Map fitted = drawing;
  RandomStream random(11);
  for (Building& house : fitted.buildings) {
    see(house);
    auto& box = std::get<Rectangle>(house.shape);
    box.centre = off.toOuter(box.centre);
    box.heading += off.heading;
    shift(house, {random.normal(0.0, 1.0), random.normal(0.0, 1.0)});
  }
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  EXPECT_TRUE(agreement.refutes_start);
  EXPECT_NEAR(agreement.motion.heading, off.heading, toRadians(2.0));
  EXPECT_LT((agreement.motion.position() - off.position()).norm(), 2.0);
  // Two rows, wall to wall: what their houses share may be drawn off.
  for (int i = 0; i < 6; ++i) {
    drawing.buildings.push_back(drawing.buildings[static_cast<std::size_t>(i)]);
    fitted.buildings.push_back(fitted.buildings[static_cast<std::size_t>(i)]);
  }
  const auto refutes = [&](const Vec2& rows_off, double drawn_width) {
    for (std::size_t b = 0; b < 12; ++b) {
      const std::size_t in_row = b / 2;
      const Vec2 at(10.0 + 12.0 * static_cast<double>(in_row), b % 2 == 0 ? 15.0 : -15.0);
      drawing.buildings[b].shape = Rectangle{at, drawn_width, 8.0, 0.0};
      fitted.buildings[b].shape = Rectangle{at + rows_off, 12.0, 8.0, 0.0};
    }
    return agreementOf(drawing, fitted, kStart_m, kStartTurn).refutes_start;
  };
  EXPECT_FALSE(refutes({2.5, 2.0}, 12.0));
  EXPECT_FALSE(refutes({2.5, 2.0}, 10.0));  // people leave gaps where there are none
  EXPECT_TRUE(refutes({5.0, 4.0}, 12.0));
  EXPECT_TRUE(refutes({5.0, 4.0}, 10.0));
}

/// All are off, the more the farther from the start.
TEST(Agreement, ADrawingOfAnotherScaleDoesNotRefuteTheStart) {
  for (const double scale : {0.75, 1.3}) {
    Map drawing = sixHouses();
    drawing.uncertainty = {2.0, 1.0};
    Map fitted = drawing;
    RandomStream random(12);
    for (Building& house : fitted.buildings) {
      see(house);
      std::get<Rectangle>(house.shape).centre *= scale;
      shift(house, {random.normal(0.0, 1.0), random.normal(0.0, 1.0)});
    }
    const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
    EXPECT_FALSE(agreement.refutes_start) << scale;
    EXPECT_EQ(agreement.motion, Pose2{}) << scale;
  }
}

/// Streets whose places were drawn one after the other, each off by about as much as the last.
TEST(Agreement, WhatIsDrawnOffTogetherDoesNotRefuteTheStart) {
  Map drawing = sixHouses();
  drawing.uncertainty = {3.0, 1.0};
  for (int i = 6; i < 24; ++i) {
    drawing.buildings.push_back(drawing.buildings[static_cast<std::size_t>(i % 2)]);
    drawing.buildings.back().id += std::to_string(i);
    shift(drawing.buildings.back(), {20.0 * (i - i % 2), 0.0});
  }
  int refuted = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    RandomStream random(seed);
    Map fitted = drawing;
    Vec2 off(random.normal(0.0, 3.0), random.normal(0.0, 3.0));
    for (Building& house : fitted.buildings) {
      see(house);
      off = 0.6 * off + 0.8 * Vec2(random.normal(0.0, 3.0), random.normal(0.0, 3.0));
      shift(house, off);
    }
    if (agreementOf(drawing, fitted, kStart_m, kStartTurn).refutes_start) ++refuted;
  }
  EXPECT_LE(refuted, 2);
}

TEST(Agreement, TakesWhatWasNotSeenAsTheRest) {
  const Map drawing = sixHouses();
  Map fitted = drawing;
  for (std::size_t b = 0; b < 5; ++b) see(fitted.buildings[b]);
  EXPECT_TRUE(agreementOf(drawing, fitted, kStart_m, kStartTurn).isRight(5));
  EXPECT_FALSE(agreementOf(drawing, drawing, kStart_m, kStartTurn).isRight(5));
}

TEST(Agreement, NeverDoubtsWhatThePersonFixed) {
  Map drawing = sixHouses();
  drawing.buildings[0].fixed = true;
  Map fitted = drawing;
  for (Building& house : fitted.buildings) {
    see(house);
    shift(house, (house.id == "A" || house.id == "D" ? 1.0 : -1.0) * Vec2(6.0, 5.0));
  }
  const Agreement agreement = agreementOf(drawing, fitted, kStart_m, kStartTurn);
  EXPECT_EQ(agreement.right[0], 1.0);
  EXPECT_FALSE(agreement.isRight(1));
}

TEST(Agreement, StandsWhateverTheDrawingStates) {
  for (const double stated : {0.0, 1e-300, 1e-9, 1e5}) {
    for (const std::size_t how_many : {1U, 6U}) {
      Map drawing = sixHouses();
      for (std::size_t b = 0; b < how_many; ++b) {
        drawing.buildings[b].uncertainty = Uncertainty{stated, stated};
      }
      Map fitted = drawing;
      for (Building& house : fitted.buildings) see(house);
      const Agreement as_drawn = agreementOf(drawing, fitted, kStart_m, kStartTurn);
      for (std::size_t b = 0; b < 6; ++b) EXPECT_TRUE(as_drawn.isRight(b)) << stated << ' ' << b;
      for (Building& house : fitted.buildings) shift(house, {4.0, -3.0});
      shift(fitted.buildings[5], {9.0, 7.0});
      const Agreement off = agreementOf(drawing, fitted, kStart_m, kStartTurn);
      for (const double right : off.right) {
        EXPECT_TRUE(right >= 0.0 && right <= 1.0) << stated << ' ' << right;
      }
      EXPECT_FALSE(off.isRight(5)) << stated;
      EXPECT_TRUE(off.covariance.allFinite() && std::isfinite(off.sigmaAt({50.0, 0.0})));
    }
  }
}

}  // namespace
}  // namespace handmap
