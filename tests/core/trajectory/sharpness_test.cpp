#include "core/trajectory/sharpness.h"

#include <gtest/gtest.h>

#include "tests/core/trajectory/walled_world.h"

namespace handmap {
namespace {

class Sharpness : public ::testing::Test {
 protected:
  Sharpness() {
    const auto walls = test::ringCorridor();
    RandomStream random(5);
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      SharpnessFrame& frame = frames_.emplace_back();
      if (i % 2 == 1) continue;  // a metre apart
      std::vector<SharpnessPoint> seen;
      const auto scan = test::scanFrom(walls, truth_[i], 0.03, random);
      for (std::size_t k = 0; k < scan.size(); k += 4) seen.push_back({{scan[k].x, scan[k].y}});
      frame = std::make_shared<const std::vector<SharpnessPoint>>(std::move(seen));
    }
  }

  double of(const std::vector<Pose2>& trajectory) const {
    return sharpnessOf(frames_, trajectory, {.apart_m = 4.5});
  }

  std::vector<Pose2> truth_ = test::aroundTheBlock(0.5);
  std::vector<SharpnessFrame> frames_;
};

TEST_F(Sharpness, IsGreatestForTheTrueWay) {
  RandomStream random(1);
  std::vector<Pose2> shaken = truth_;
  for (Pose2& pose : shaken) {
    pose = {pose.x + random.normal(0, 0.3), pose.y + random.normal(0, 0.3),
            pose.heading + random.normal(0, 0.02)};
  }
  const double truth = of(truth_);
  EXPECT_GT(truth, of(shaken) + 0.3);
  EXPECT_GT(truth, of(test::slipping(truth_, random)) + 0.1);
}

TEST_F(Sharpness, DoesNotDependOnWhereTheWayLies) {
  std::vector<Pose2> elsewhere;
  for (const Pose2& pose : truth_) elsewhere.push_back(Pose2{100, -50, 1.1} * pose);
  EXPECT_NEAR(of(elsewhere), of(truth_), 0.02);
}

TEST_F(Sharpness, IsTheSameEveryTime) { EXPECT_EQ(of(truth_), of(truth_)); }

TEST(WaySharpnessOfNothing, IsZero) {
  EXPECT_EQ(sharpnessOf({}, {}), 0.0);
  EXPECT_EQ(sharpnessOf({{}, {}}, {Pose2{}, Pose2{1, 0, 0}}), 0.0);
}

}  // namespace
}  // namespace handmap
