#include "core/classification/edge_statistics.h"

#include <numeric>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

/// Of the middle one of 3×3 windows with this brightness.
template <typename Brightness>
EdgeStatistics middleOf(Brightness brightness) {
  cv::Mat1b grey(3 * kWindow_px, 3 * kWindow_px);
  for (int y = 0; y < grey.rows; ++y) {
    for (int x = 0; x < grey.cols; ++x) grey(y, x) = static_cast<std::uint8_t>(brightness(x, y));
  }
  return edgeStatistics(grey).at(4);
}

TEST(EdgeStatistics, OfNothingAreNone) {
  const EdgeStatistics flat = middleOf([](int, int) { return 90; });
  EXPECT_EQ(flat.density, 0.0F);
  EXPECT_EQ(flat.hough_peak, 0.0F);
  EXPECT_EQ(flat.direction_variance, 1.0F);
  EXPECT_EQ(flat.contrast, 0.0F);
}

TEST(EdgeStatistics, OfAStepAreOneLine) {
  const EdgeStatistics upright = middleOf([](int x, int) { return x < 24 ? 50 : 150; });
  EXPECT_FLOAT_EQ(upright.density, 2.0F / kWindow_px);
  EXPECT_FLOAT_EQ(upright.hough_peak, 1.0F);
  EXPECT_NEAR(upright.direction_variance, 0.0F, 1e-6F);
  EXPECT_FLOAT_EQ(upright.directions[0], 1.0F);
  EXPECT_NEAR(upright.contrast, 50.0F / 255.0F, 1e-5F);
  const EdgeStatistics level = middleOf([](int, int y) { return y < 24 ? 50 : 150; });
  EXPECT_FLOAT_EQ(level.directions[kEdgeDirections / 2], 1.0F);
}

TEST(EdgeStatistics, OfSlantedStepsPointAlongThem) {
  const EdgeStatistics falling = middleOf([](int x, int y) { return x + y < 48 ? 50 : 150; });
  EXPECT_GT(falling.directions[2], 0.95F);
  EXPECT_GT(falling.hough_peak, 0.6F);
  const EdgeStatistics rising = middleOf([](int x, int y) { return x < y ? 50 : 150; });
  EXPECT_GT(rising.directions[6], 0.95F);
}

TEST(EdgeStatistics, OfNoiseHaveNoDirection) {
  RandomStream random(1);
  const EdgeStatistics noise = middleOf([&](int, int) { return random.index(256); });
  EXPECT_GT(noise.density, 0.7F);
  EXPECT_GT(noise.direction_variance, 0.7F);
  EXPECT_LT(noise.hough_peak, 0.5F);
  EXPECT_NEAR(std::accumulate(noise.directions.begin(), noise.directions.end(), 0.0F), 1.0F, 1e-5F);
}

TEST(EdgeStatistics, LeaveOutPartialWindows) {
  EXPECT_EQ(edgeStatistics(cv::Mat1b(40, 60, std::uint8_t{0})).size(), 6U);
}

}  // namespace
}  // namespace handmap
