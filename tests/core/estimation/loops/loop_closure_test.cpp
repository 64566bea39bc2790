#include "core/estimation/loops/loop_closure.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace handmap {
namespace {

FoundBox known(const Rectangle& rectangle) {
  FoundBox found{boxOf(rectangle)};
  found.covariance = 0.01 * Eigen::Matrix4d::Identity();
  found.heading_sigma = 0.01;
  return found;
}

/// As a way that has drifted about `here` shows it.
FoundBox drifted(const FoundBox& found, const Vec2& here, const Pose2& drift) {
  Rectangle box = found.box.rectangle();
  const Pose2 frame{here.x() + drift.x, here.y() + drift.y, drift.heading};
  box.centre = frame.toOuter(box.centre - here);
  box.heading += drift.heading;
  return known(box);
}

class LoopClosureTest : public testing::Test {
 protected:
  LoopClosureTest() {
    for (const FoundBox& old :
         {known({{0.0, 15.0}, 20.0, 8.0, 0.1}), known({{35.0, -14.0}, 30.0, 12.0, 0.0}),
          known({{50.0, 16.0}, 14.0, 11.0, -0.1})}) {
      boxes_.push_back(old);
    }
    for (std::size_t i = 0; i < 3; ++i) boxes_.push_back(drifted(boxes_[i], prior_.here, kDrift));
    for (std::size_t i = 0; i < 6; ++i) boxes_[i].id = static_cast<FoundId>(i);
  }

  static SameBuilding pair(int old, int again) {
    return {static_cast<FoundId>(old), static_cast<FoundId>(again)};
  }
  /// The same box, found elsewhere.
  void drift(std::size_t box, const Pose2& by) {
    const FoundId id = boxes_[box].id;
    boxes_[box] = drifted(boxes_[box], prior_.here, by);
    boxes_[box].id = id;
  }

  static constexpr Pose2 kDrift{5.0, -4.0, 0.05};
  DriftPrior prior_{Vec2(20.0, 0.0), 6.0, 0.06};
  std::vector<FoundBox> boxes_;  ///< three old ones, and the same found again
};

TEST_F(LoopClosureTest, ABoxAgreesWithItself) {
  const std::vector<SharedParameter> shared = compare(boxes_[0], boxes_[0].nearestTo(kPi / 2.0));
  ASSERT_EQ(shared.size(), 5U);
  for (const SharedParameter& parameter : shared) EXPECT_NEAR(parameter.error, 0.0, 1e-9);
}

TEST_F(LoopClosureTest, SlopesTellHowTheErrorChanges) {
  constexpr double kStep = 1e-6;
  const auto moved = [&](FoundBox box, std::size_t parameter) {
    parameter == 4 ? box.box.heading += kStep : box.box.reach[parameter] += kStep;
    return box;
  };
  const auto before = compare(boxes_[0], boxes_[3]);
  for (std::size_t p = 0; p < 5; ++p) {
    const auto old_moved = compare(moved(boxes_[0], p), boxes_[3]);
    const auto again_moved = compare(boxes_[0], moved(boxes_[3], p));
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(p);
      const double by_old = (old_moved[i].error - before[i].error) / kStep;
      const double by_again = (again_moved[i].error - before[i].error) / kStep;
      EXPECT_NEAR(before[i].old_slope[at], by_old, 0.01) << i << " " << p;
      // That the middle of a wall moves along it matters little.
      EXPECT_NEAR(before[i].again_slope[at], by_again, 0.06) << i << " " << p;
    }
  }
}

TEST_F(LoopClosureTest, BuildingsThatMovedTogetherCloseIt) {
  const auto pairs =
      closeLoop(boxes_, std::vector<SameBuilding>{pair(0, 3), pair(1, 4), pair(2, 5)}, prior_);
  ASSERT_TRUE(pairs.has_value());
  EXPECT_EQ(pairs->size(), 3U);
}

TEST_F(LoopClosureTest, AWrongLabelIsLeftOut) {
  drift(5, {0.0, 8.0, 0.0});
  const auto pairs =
      closeLoop(boxes_, std::vector<SameBuilding>{pair(0, 3), pair(1, 4), pair(2, 5)}, prior_);
  ASSERT_TRUE(pairs.has_value());
  ASSERT_EQ(pairs->size(), 2U);
  for (const SameBuilding& p : *pairs) EXPECT_NE(p.old, static_cast<FoundId>(2));
}

TEST_F(LoopClosureTest, OneBuildingMayBeAny) {
  EXPECT_FALSE(closeLoop(boxes_, std::vector<SameBuilding>{pair(0, 3)}, prior_).has_value());
  drift(4, {0.0, 8.0, 0.0});
  EXPECT_FALSE(
      closeLoop(boxes_, std::vector<SameBuilding>{pair(0, 3), pair(1, 4)}, prior_).has_value());
}

TEST_F(LoopClosureTest, OfEachPairTheOldNameIsKept) {
  std::reverse(boxes_.begin(), boxes_.end());
  const auto kept = merged(boxes_, std::vector<SameBuilding>{pair(0, 3), pair(2, 5)});
  std::vector<int> ids;
  for (const FoundBox& box : kept) ids.push_back(static_cast<int>(box.id));
  EXPECT_EQ(ids, (std::vector<int>{4, 2, 1, 0}));
}

TEST_F(LoopClosureTest, WhatIsMergedKnowsWhatEitherKnew) {
  FoundBox front = boxes_[0];
  front.setReachSigma(1, 4.0);
  front.first_frame = 3;
  front.dormant = true;
  FoundBox back = known({{0.0, 16.0}, 20.0, 10.0, 0.1});
  back.setReachSigma(3, 4.0);
  back.last_frame = 90;
  const FoundBox both = merged(front, back);
  EXPECT_FALSE(both.dormant);
  EXPECT_EQ(both.first_frame, 3U);
  EXPECT_EQ(both.last_frame, 90U);
  EXPECT_LT(both.reachSigma(1), 0.2);
  EXPECT_LT(both.reachSigma(3), 0.2);
  EXPECT_NEAR(both.box.reach[3], front.box.reach[3], 1e-9);
  const Vec2 far_wall = back.box.pivot + back.box.reach[1] * back.box.normal(1);
  EXPECT_NEAR(both.box.normal(1).dot(far_wall - both.box.pivot), both.box.reach[1], 1e-9);
}

}  // namespace
}  // namespace handmap
