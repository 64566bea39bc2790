#include "core/classification/equalization.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace handmap {
namespace {

TEST(Equalization, MakesEveryBrightnessAboutAsFrequent) {
  cv::Mat1b dark(16, 64);
  for (int y = 0; y < dark.rows; ++y) {
    for (int x = 0; x < dark.cols; ++x) dark(y, x) = static_cast<std::uint8_t>(x / 2);
  }
  const cv::Mat1b bright = equalized(dark);
  EXPECT_EQ(bright(0, 63), 255);
  EXPECT_NEAR(cv::mean(bright)[0], 128.0, 6.0);
  EXPECT_LT(bright(0, 20), bright(0, 22));
}

TEST(Equalization, HasOneCurveForAllChannels) {
  cv::Mat3b image(2, 2, cv::Vec3b(10, 20, 30));
  image(1, 1) = cv::Vec3b(20, 20, 20);
  const cv::Mat3b result = equalized(image);
  EXPECT_EQ(result(0, 0)[1], result(1, 1)[0]);
  EXPECT_LE(result(0, 0)[0], result(0, 0)[2]);
  EXPECT_EQ(image(0, 0), cv::Vec3b(10, 20, 30));  // as it was
}

}  // namespace
}  // namespace handmap
