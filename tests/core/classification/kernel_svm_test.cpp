#include "core/classification/kernel_svm.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/classification/logistic.h"

namespace handmap {
namespace {

struct Ring {
  SampleMatrix samples;
  std::vector<bool> inside;
};

/// No line can part them; `share_inside` of the samples are in the disk, the rest around it.
Ring makeRing(int count, double share_inside, std::uint64_t seed) {
  RandomStream random(seed);
  Ring ring{SampleMatrix(count, 2), {}};
  for (int i = 0; i < count; ++i) {
    const bool inside = random.uniform() < share_inside;
    const double radius = inside ? random.uniform(0.0, 0.9) : random.uniform(1.1, 2.0);
    const double angle = random.uniform(0.0, 6.28);
    ring.samples(i, 0) = static_cast<float>(radius * std::cos(angle));
    ring.samples(i, 1) = static_cast<float>(radius * std::sin(angle));
    ring.inside.push_back(inside);
  }
  return ring;
}

double rightOnes(const KernelSvm& svm, const Ring& ring) {
  const Eigen::VectorXf distances = svm.decide(ring.samples);
  int right = 0;
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    right += (distances[i] > 0.0F) == ring.inside[static_cast<std::size_t>(i)];
  }
  return static_cast<double>(right) / static_cast<double>(distances.size());
}

TEST(KernelSvm, PartsADiskFromTheRingAroundIt) {
  const Ring ring = makeRing(600, 0.5, 1);
  const KernelSvm svm = KernelSvm::train(ring.samples, ring.inside, {.vectors = 40, .gamma = 2.0});
  EXPECT_EQ(svm.vectors().rows(), 40);
  EXPECT_GT(rightOnes(svm, makeRing(1000, 0.5, 2)), 0.97);
}

TEST(KernelSvm, IsNotSwayedByRareClasses) {
  const Ring ring = makeRing(1500, 0.03, 3);
  const KernelSvm svm = KernelSvm::train(ring.samples, ring.inside, {.vectors = 40, .gamma = 2.0});
  EXPECT_GT(rightOnes(svm, makeRing(500, 1.0, 4)), 0.9);
  EXPECT_GT(rightOnes(svm, makeRing(500, 0.0, 5)), 0.9);
}

TEST(KernelSvm, DependsOnTheSeedAlone) {
  const Ring ring = makeRing(300, 0.5, 6);
  const auto train = [&](std::uint64_t seed) {
    return KernelSvm::train(ring.samples, ring.inside, {.vectors = 20, .seed = seed});
  };
  EXPECT_EQ(train(1).weights(), train(1).weights());
  EXPECT_NE(train(1).weights(), train(2).weights());
}

TEST(KernelSvm, MakesDoWithFewSamples) {
  const Ring ring = makeRing(12, 0.5, 7);
  const KernelSvm svm = KernelSvm::train(ring.samples, ring.inside, {.gamma = 2.0});
  EXPECT_EQ(svm.vectors().rows(), 12);
  EXPECT_TRUE(svm.weights().allFinite());
  EXPECT_EQ(rightOnes(svm, ring), 1.0);
}

TEST(Logistic, FindsTheCurveThatSamplesCameFrom) {
  RandomStream random(1);
  const Logistic truth{2.5, -0.7};
  Eigen::VectorXf distances(20000);
  std::vector<bool> positive;
  for (float& distance : distances) {
    distance = static_cast<float>(random.uniform(-2.0, 2.0));
    positive.push_back(random.uniform() < static_cast<double>(truth(distance)));
  }
  const auto positives = static_cast<double>(std::count(positive.begin(), positive.end(), true));
  const double odds = positives / (20000.0 - positives);
  const Logistic found = Logistic::fit(distances, positive);
  EXPECT_NEAR(found.slope, truth.slope, 0.1);
  // As if both classes were equally frequent.
  EXPECT_NEAR(found.offset, truth.offset - std::log(odds), 0.08);
}

TEST(Logistic, StaysFiniteWhereNothingOverlaps) {
  Eigen::VectorXf distances(6);
  distances << -3, -2, -1, 1, 2, 3;
  const Logistic found = Logistic::fit(distances, {false, false, false, true, true, true});
  EXPECT_GT(found(1.0F), 0.6F);
  EXPECT_LT(found(-1.0F), 0.4F);
  EXPECT_LT(found.slope, 100.0);
}

}  // namespace
}  // namespace handmap
