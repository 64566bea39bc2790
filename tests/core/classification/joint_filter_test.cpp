#include "core/classification/joint_filter.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace handmap {
namespace {

/// 12 × 8 windows: a wall at the left, sky at the right.
cv::Mat3b wallAndSky() {
  cv::Mat3b image(130, 200, cv::Vec3b(60, 80, 100));
  image.colRange(96, 200) = cv::Vec3b(240, 230, 220);
  return image;
}

TEST(JointFilter, FillsWallsAndStopsAtTheSky) {
  cv::Mat1f windows(8, 12, 0.1F);
  windows.colRange(0, 6) = 0.9F;
  windows(4, 2) = 0.2F;  // a hole
  windows(3, 6) = 0.8F;  // what is left of the wall in the sky
  const cv::Mat1f filtered = jointlyFiltered(windows, wallAndSky());
  ASSERT_EQ(filtered.size(), windows.size());
  EXPECT_GT(filtered(4, 2), 0.8F);
  EXPECT_GT(filtered(4, 5), 0.85F);
  EXPECT_LT(filtered(3, 6), 0.2F);
  EXPECT_LT(filtered(4, 6), 0.2F);
}

TEST(JointFilter, LeavesWhatIsTheSameEverywhere) {
  const cv::Mat1f windows(8, 12, 0.7F);
  cv::Mat1b grey(128, 192, std::uint8_t{90});
  EXPECT_LT(cv::norm(jointlyFiltered(windows, grey), windows, cv::NORM_INF), 1e-5);
  EXPECT_LT(cv::norm(jointlyFiltered(windows, wallAndSky()), windows, cv::NORM_INF), 1e-5);
}

}  // namespace
}  // namespace handmap
