#include "core/perception/wall_columns.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr double kColumnRange_m = 40.0;
constexpr double kUp_m = 1.5;

/// Level, 1.5 m above the ground; the image ends 5.4 m above that at a distance of 10 m.
const StereoCamera kCamera{700.0, 700.0, 319.5, 273.0, 0.5, {0.0, 0.0, kUp_m, 0.0, 0.0}};

class WallColumns : public testing::Test {
 protected:
  /// Everything between two heights above the ground at a distance, in columns `first` to `last`.
  void show(double distance_m, double low_m, double high_m, int first, int last) {
    for (int row = 0; row < disparity_.rows; ++row) {
      const double height = kUp_m + (kCamera.cy - row) / kCamera.fy * distance_m;
      if (height < low_m || height > high_m) continue;
      const auto value = static_cast<float>(kCamera.fx * kCamera.baseline / distance_m);
      disparity_.row(row).colRange(first, last + 1).setTo(value);
    }
  }

  std::vector<WallColumn> found(double range_m = kColumnRange_m) const {
    const CameraRays rays(kCamera, disparity_.size());
    return wallColumns(disparity_, kCamera, rays, {}, {}, range_m);
  }

  cv::Mat1f disparity_ = cv::Mat1f(400, 640, -1.0F);
};

TEST_F(WallColumns, OfAWallAreWhereItIs) {
  show(10.0, 0.0, 9.0, 100, 199);
  const auto columns = found();
  ASSERT_EQ(columns.size(), 100U);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const WallColumn& wall = columns[i];
    EXPECT_EQ(wall.column, 100 + static_cast<int>(i));
    EXPECT_NEAR(wall.x, 10.0, 0.01);
    EXPECT_NEAR(wall.y, (kCamera.cx - wall.column) / kCamera.fx * 10.0, 0.01);
    EXPECT_NEAR(wall.extent_m, 5.4 - 1.9, 0.05);
    EXPECT_NEAR(wall.row, 122.0, 1.0);  // the middle of those above 1.9 m
    EXPECT_EQ(wall.building, 1.0);
  }
}

TEST_F(WallColumns, AreNotSeenInWhatEndsLow) {
  show(10.0, 0.0, 2.6, 100, 199);
  EXPECT_TRUE(found().empty());
  show(10.0, 0.0, 3.2, 150, 159);
  EXPECT_EQ(found().size(), 10U);
}

TEST_F(WallColumns, AreNotSeenBeyondTheRange) {
  show(30.0, 0.0, 12.0, 100, 109);
  EXPECT_EQ(found().size(), 10U);
  EXPECT_TRUE(found(25.0).empty());
}

TEST_F(WallColumns, OfTwoWallsOneBehindTheOtherComeNearFirst) {
  show(20.0, 0.0, 12.0, 300, 300);
  show(8.0, 0.0, 3.5, 300, 300);
  const auto columns = found();
  ASSERT_EQ(columns.size(), 2U);
  EXPECT_NEAR(columns[0].x, 8.0, 0.01);
  EXPECT_NEAR(columns[0].extent_m, 3.5 - 1.9, 0.05);
  EXPECT_NEAR(columns[1].x, 20.0, 0.03);
  EXPECT_LT(columns[1].row, columns[0].row);
}

TEST_F(WallColumns, OfNothingAreNone) { EXPECT_TRUE(found().empty()); }

}  // namespace
}  // namespace handmap
