#include "core/outlines/evolution.h"

#include <cmath>

#include <gtest/gtest.h>

namespace handmap {
namespace {

/// A narrow bent valley; 0 at (1, 1, …).
double rosenbrock(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    sum += 100.0 * std::pow(x[i + 1] - x[i] * x[i], 2) + std::pow(1.0 - x[i], 2);
  }
  return -sum;
}

constexpr Evolution kPatient{.step = 0.5, .least_step = 1e-6, .most_generations = 600};

TEST(Evolution, FollowsABentValley) {
  RandomStream random(1);
  const Evolved best = evolve(rosenbrock, Eigen::VectorXd::Zero(5), kPatient, random);
  EXPECT_GT(best.value, -1e-6);
  EXPECT_TRUE(best.parameters.isApprox(Eigen::VectorXd::Ones(5), 1e-3)) << best.parameters;
}

TEST(Evolution, IsNotHeldUpByRipples) {
  const auto rippled = [](const Eigen::VectorXd& x) {
    return -x.squaredNorm() + 0.3 * (20.0 * x).array().cos().sum();
  };
  RandomStream random(2);
  const Evolved best = evolve(rippled, Eigen::VectorXd::Constant(6, 1.5), {1.0, 1e-3, 200}, random);
  EXPECT_LT(best.parameters.norm(), 0.8) << best.parameters.transpose();
}

TEST(Evolution, IsTheSameWithTheSameNumbers) {
  RandomStream one(3);
  RandomStream other(3);
  const Eigen::VectorXd start = Eigen::VectorXd::Constant(3, -1.0);
  const Evolved a = evolve(rosenbrock, start, {}, one);
  const Evolved b = evolve(rosenbrock, start, {}, other);
  EXPECT_EQ(a.parameters, b.parameters);
  EXPECT_EQ(a.value, b.value);
}

TEST(Evolution, KeepsAStartThatNothingIsBetterThan) {
  RandomStream random(4);
  const Eigen::VectorXd top = Eigen::VectorXd::Ones(4);
  const Evolved best = evolve(rosenbrock, top, {}, random);
  EXPECT_EQ(best.parameters, top);
  EXPECT_EQ(best.value, 0.0);
}

TEST(Evolution, ComesBackWhereAStopIsRequested) {
  RandomStream random(5);
  std::stop_source stop;
  int asked = 0;
  const auto value = [&](const Eigen::VectorXd& x) {
    if (++asked == 30) stop.request_stop();
    return rosenbrock(x);
  };
  evolve(value, Eigen::VectorXd::Zero(4), kPatient, random, stop.get_token());
  EXPECT_EQ(asked, 30);
}

}  // namespace
}  // namespace handmap
