#include "core/geometry/pose2.h"

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

constexpr double kTolerance = 1e-12;

Pose2 randomPose(RandomStream& random) {
  return {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-kPi, kPi)};
}

void expectNear(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(normalizedAngle(a.heading - b.heading), 0.0, kTolerance);
}

TEST(Pose2, NormalizesAnglesIntoHalfOpenTurn) {
  EXPECT_DOUBLE_EQ(normalizedAngle(kPi), kPi);
  EXPECT_DOUBLE_EQ(normalizedAngle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(normalizedAngle(0.0), 0.0);
  EXPECT_NEAR(normalizedAngle(7.0), 7.0 - 2.0 * kPi, kTolerance);
  EXPECT_NEAR(normalizedAngle(-7.0), 2.0 * kPi - 7.0, kTolerance);
  RandomStream random(1);
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.uniform(-100, 100);
    const double wrapped = normalizedAngle(angle);
    EXPECT_TRUE(wrapped > -kPi && wrapped <= kPi);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), kTolerance);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), kTolerance);
  }
}

TEST(Pose2, MovesPointsBetweenFrames) {
  const Pose2 pose{10.0, 20.0, kPi / 2.0};
  EXPECT_TRUE(pose.toOuter({1.0, 0.0}).isApprox(Vec2(10.0, 21.0)));
  EXPECT_TRUE(pose.toOwn({10.0, 21.0}).isApprox(Vec2(1.0, 0.0)));
}

TEST(Pose2, ComposesInvertsAndDifferences) {
  expectNear(Pose2{1, 2, kPi / 2} * Pose2{3, 0, 0.25}, {1, 5, kPi / 2 + 0.25});
  RandomStream random(2);
  for (int i = 0; i < 200; ++i) {
    const Pose2 a = randomPose(random);
    const Pose2 b = randomPose(random);
    const Pose2 c = randomPose(random);
    expectNear(a * inverse(a), {});
    expectNear(inverse(a) * a, {});
    expectNear((a * b) * c, a * (b * c));
    expectNear(a * between(a, b), b);
    expectNear(between(a, b), inverse(a) * b);
    const Vec2 p(random.uniform(-9, 9), random.uniform(-9, 9));
    EXPECT_TRUE((a * b).toOuter(p).isApprox(a.toOuter(b.toOuter(p)), 1e-9));
    EXPECT_TRUE(a.toOwn(a.toOuter(p)).isApprox(p, 1e-9));
  }
}

TEST(Pose2, InterpolatesTheShortWayRound) {
  const Pose2 a{0.0, 0.0, toRadians(170.0)};
  const Pose2 b{2.0, 4.0, toRadians(-170.0)};
  expectNear(interpolated(a, b, 0.0), a);
  expectNear(interpolated(a, b, 1.0), b);
  expectNear(interpolated(a, b, 0.5), {1.0, 2.0, kPi});
  expectNear(interpolated(a, b, 0.25), {0.5, 1.0, toRadians(175.0)});
}

}  // namespace
}  // namespace handmap
