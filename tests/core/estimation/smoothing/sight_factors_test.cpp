#include "core/estimation/smoothing/sight_factors.h"

#include "tests/core/estimation/scene.h"
#include "tests/core/estimation/smoothing/numeric.h"

namespace handmap {
namespace {

constexpr double kLimit = 40.0;

MeasuredSensor quiet() {
  MeasuredSensor measured;
  measured.noise = {0.1, 0.0};
  return measured;
}

class SightFactorsTest : public testing::Test {
 protected:
  /// A return along `bearing` from a little behind where the box would be met.
  FrameRay rayAt(double bearing, double behind_m) const {
    FrameRay ray{static_cast<float>(std::cos(bearing)),
                 static_cast<float>(std::sin(bearing)),
                 static_cast<float>(bearing),
                 {}};
    const Entry entry = BoxView(box_, pose_).entry(ray);
    ray.sight = {entry.distance + static_cast<float>(behind_m), walls::kLabels - 1};
    return ray;
  }
  std::optional<ScalarFactor<SightEquations::kSize>> factorOf(const FrameRay& ray) const {
    return ReturnFactors(pose_, box_, sensor_, errors_)(ray, BoxView(box_, pose_).entry(ray));
  }
  std::vector<Change> unknowns() {
    std::vector<Change> all = unknownsOf(pose_);
    append(all, unknownsOf(box_));
    all.push_back(unknown(errors_.bias_per_m));
    return all;
  }
  /// How far across the wall the point of a return is that was as long as the model has it.
  void expectSlopesOf(double bearing) {
    const FrameRay ray = rayAt(bearing, 0.0);
    const Entry entry = BoxView(box_, pose_).entry(ray);
    const auto wall = static_cast<std::size_t>(entry.wall);
    const auto factor = factorOf(ray);
    ASSERT_TRUE(factor);
    expectSlopes(
        factor->slope.transpose().eval(), unknowns(),
        [&]() -> Eigen::VectorXd {
          const double squared = static_cast<double>(entry.distance * entry.distance);
          const double range = static_cast<double>(ray.sight.range) - errors_.bias_per_m * squared;
          const Vec2 point = pose_.toOuter(range * Vec2(ray.x, ray.y));
          return Eigen::VectorXd::Constant(1, box_.normal(wall).dot(point - box_.corner(wall)));
        },
        2e-4);  // rays are single precision
  }

  Pose2 pose_{0.5, -1.0, 0.3};
  Box box_ = boxOf({{2.0, 15.0}, 20.0, 8.0, 0.2});
  SensorModel sensor_{quiet(), kLimit};
  SightErrors errors_{0.1, 0.03, 0.0};
};

TEST_F(SightFactorsTest, SlopesOfAReturnAreThoseOfItsDistance) {
  for (const double bearing : {0.9, 1.2, 1.5}) expectSlopesOf(bearing);
}

TEST_F(SightFactorsTest, AReturnPullsTheWallTowardsIt) {
  const auto behind = factorOf(rayAt(1.2, 0.1));
  const auto before = factorOf(rayAt(1.2, -0.1));
  ASSERT_TRUE(behind && before);
  EXPECT_GT(behind->weight, 0.0);
  // The front wall faces the robot: what is behind it lies inwards.
  EXPECT_LT(behind->residual, 0.0);
  EXPECT_GT(before->residual, 0.0);
}

TEST_F(SightFactorsTest, WhatIsFarFromTheWallIsNotFromIt) {
  EXPECT_TRUE(factorOf(rayAt(1.2, 0.3)));
  EXPECT_FALSE(factorOf(rayAt(1.2, 3.0)));
  EXPECT_FALSE(factorOf(rayAt(1.2, -3.0)));
}

TEST_F(SightFactorsTest, NearTheRangeLimitNothingIsTold) {
  sensor_ = SensorModel(quiet(), 10.5);
  EXPECT_FALSE(factorOf(rayAt(1.2, 0.0)));
}

TEST_F(SightFactorsTest, SlopesOfAnEndAreThoseOfItsBearing) {
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const SeenEnd end{corner, 0.8, 0.01};
    const auto factor = endFactor(pose_, box_, end, errors_);
    std::vector<Change> states = unknowns();
    expectSlopes(factor.slope.transpose().eval(), states, [&]() -> Eigen::VectorXd {
      return Eigen::VectorXd::Constant(1, endFactor(pose_, box_, end, errors_).residual);
    });
  }
}

TEST_F(SightFactorsTest, WhatOneFrameSaysIsBoundedHoweverManyReturnsThereAre) {
  RandomStream random(3);
  const auto information = [&](int rays) {
    RandomStream some = random;
    const Frame frame = seenFrom(pose_, {box_}, 0.1, some, rays);
    const auto equations = sightEquations(frame, box_, sensor_, errors_);
    return equations ? equations->matrix(1, 1) : 0.0;
  };
  const double most = 1.0 / (errors_.systematic_m * errors_.systematic_m);
  EXPECT_GT(information(720), 0.5 * most);
  EXPECT_LT(information(7200), 2.5 * most);  // two walls, and the ends
  EXPECT_GT(information(7200), information(90));
}

TEST_F(SightFactorsTest, ABoxOutOfReachOrAroundTheRobotIsNotSeen) {
  RandomStream random(4);
  const Frame frame = seenFrom(pose_, {box_}, 0.1, random);
  EXPECT_FALSE(sightEquations(frame, boxOf({{200.0, 0.0}, 20.0, 8.0, 0.0}), sensor_, errors_));
  EXPECT_FALSE(sightEquations(frame, boxOf({{0.0, 0.0}, 20.0, 8.0, 0.0}), sensor_, errors_));
}

}  // namespace
}  // namespace handmap
