#include "core/fastslam/resampling.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

TEST(Resampling, NormalizesToOne) {
  std::vector<double> weights{1.0, 3.0};
  normalize(weights);
  EXPECT_DOUBLE_EQ(weights[0], 0.25);
  EXPECT_DOUBLE_EQ(weights[1], 0.75);
}

TEST(Resampling, WithoutAnyWeightAllAreEqual) {
  std::vector<double> weights{0.0, 0.0, 0.0, 0.0};
  normalize(weights);
  for (const double weight : weights) EXPECT_DOUBLE_EQ(weight, 0.25);
}

TEST(Resampling, EffectiveSampleSizeIsTheirNumberWhenEqualAndOneWhenOneHasAll) {
  EXPECT_DOUBLE_EQ(effectiveSampleSize({0.25, 0.25, 0.25, 0.25}), 4.0);
  EXPECT_DOUBLE_EQ(effectiveSampleSize({0.0, 1.0, 0.0, 0.0}), 1.0);
}

TEST(Resampling, DrawsEveryParticleAsOftenAsItsWeightSaysUpToOne) {
  RandomStream random(7);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> weights;
    for (int i = 0; i < 50; ++i) weights.push_back(random.uniform() < 0.2 ? 0.0 : random.uniform());
    normalize(weights);
    const std::vector<int> drawn = systematicResample(weights, random.uniform());
    ASSERT_EQ(drawn.size(), weights.size());
    std::vector<int> times(weights.size(), 0);
    for (const int i : drawn) ++times[static_cast<std::size_t>(i)];
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const double expected = weights[i] * static_cast<double>(weights.size());
      EXPECT_GE(times[i], std::floor(expected - 1e-9));
      EXPECT_LE(times[i], std::ceil(expected + 1e-9));
    }
  }
}

}  // namespace
}  // namespace handmap
