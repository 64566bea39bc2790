#include "core/method/recognition.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr WallRays::Share kMet{100, 20, 20, 2};
constexpr WallRays::Share kNotDrawn{100, 0, 2, 0};
constexpr WallRays::Share kSeenThrough{100, 2, 4, 30};

double widened(const Recognition& recognition) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  recognition.widen(covariance);
  return covariance(0, 0);
}

void drive(Recognition& recognition, const WallRays::Share& share, int metres) {
  for (int i = 0; i < metres; ++i) recognition.look(share, 1.0);
}

TEST(Recognition, CountsFromTheLastWallOfTheDrawing) {
  Recognition recognition;
  drive(recognition, kNotDrawn, 60);
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 60.0);
  recognition.look({4, 0, 0, 0}, 30.0);  // hardly a wall: this says nothing
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 60.0);
  recognition.look(kMet, 1.0);
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 0.0);
}

TEST(Recognition, WhoLooksThroughDrawnWallsIsLost) {
  Recognition recognition;
  drive(recognition, kSeenThrough, 30);
  EXPECT_EQ(widened(recognition), 1.0) << "drawings are wrong in places";
  drive(recognition, kSeenThrough, 60);
  EXPECT_GT(std::sqrt(widened(recognition)), 20.0);
  recognition.look(kMet, 1.0);
  EXPECT_GT(std::sqrt(widened(recognition)), 20.0) << "one look may be a mistake";
  drive(recognition, kMet, 60);
  EXPECT_EQ(widened(recognition), 1.0);
}

/// Nobody draws all that stands along a way; but who never met anything that is drawn is elsewhere.
TEST(Recognition, AGapWithoutDrawnWallsLosesNobodyWhoWasRight) {
  Recognition right;
  drive(right, kMet, 60);
  drive(right, kNotDrawn, 400);
  EXPECT_EQ(widened(right), 1.0);
  Recognition wrong;
  drive(wrong, kNotDrawn, 400);
  EXPECT_GT(widened(wrong), 10.0);
}

}  // namespace
}  // namespace handmap
