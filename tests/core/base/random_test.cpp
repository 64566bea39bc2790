#include "core/base/random.h"

#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace handmap {
namespace {

// The published known answer of philox4x32-10 for counter 0 and key 0.
TEST(Random, GivesThePublishedBits) {
  RandomStream stream(0);
  for (const std::uint32_t expected : {0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u}) {
    EXPECT_EQ(stream(), expected);
  }
}

TEST(Random, SameStreamSameDrawsOtherStreamOtherDraws) {
  std::set<std::uint32_t> firsts;
  for (std::uint64_t seed : {1ull, 2ull, 1ull << 32}) {
    for (std::uint32_t a = 0; a < 3; ++a) {
      for (std::uint32_t b = 0; b < 3; ++b) {
        for (std::uint32_t c = 0; c < 3; ++c) {
          RandomStream one(seed, a, b, c);
          RandomStream again(seed, a, b, c);
          firsts.insert(one());
          again();
          for (int i = 0; i < 10; ++i) ASSERT_EQ(one(), again());
        }
      }
    }
  }
  EXPECT_EQ(firsts.size(), 81u);
}

TEST(Random, UniformIsInItsRangeAndEven) {
  RandomStream stream(3);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = stream.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.005);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.005);
  for (int i = 0; i < 100; ++i) {
    const double u = stream.uniform(-3.0, -1.0);
    EXPECT_TRUE(u >= -3.0 && u < -1.0);
  }
}

TEST(Random, NormalHasItsMoments) {
  RandomStream stream(4);
  double sum = 0.0;
  double squares = 0.0;
  double fourths = 0.0;
  double neighbours = 0.0;
  double previous = 0.0;
  constexpr int kDraws = 200'000;
  for (int i = 0; i < kDraws; ++i) {
    const double z = stream.normal();
    ASSERT_TRUE(std::isfinite(z));
    sum += z;
    squares += z * z;
    fourths += z * z * z * z;
    neighbours += z * previous;
    previous = z;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.01);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.015);
  EXPECT_NEAR(fourths / kDraws, 3.0, 0.1);
  EXPECT_NEAR(neighbours / kDraws, 0.0, 0.01);
  RandomStream scaled(5);
  RandomStream plain(5);
  EXPECT_DOUBLE_EQ(scaled.normal(10.0, 2.0), 10.0 + 2.0 * plain.normal());
}

TEST(Random, SeveralNormalsAreDrawnFromTheLastToTheFirst) {
  RandomStream together(7);
  RandomStream single(7);
  const std::array<double, 3> three = together.normals<3>();
  for (std::size_t i = 3; i-- > 0;) EXPECT_EQ(three[i], single.normal()) << i;
}

TEST(Random, IndexCoversItsRange) {
  RandomStream stream(6);
  std::vector<int> counts(7);
  for (int i = 0; i < 7000; ++i) ++counts.at(static_cast<std::size_t>(stream.index(7)));
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
  EXPECT_EQ(stream.index(1), 0);
}

}  // namespace
}  // namespace handmap
