#include "core/method/recognition.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr WallRays::Share kMet{100, 20, 20, 2};
constexpr WallRays::Share kNotDrawn{100, 0, 2, 0};
constexpr WallRays::Share kSeenThrough{100, 2, 4, 30};

FrameReport stated(const Recognition& recognition) {
  FrameReport report;
  recognition.state(Eigen::Matrix3d::Identity(), report);
  return report;
}

/// σ of a pose that is known to a metre.
double widened(const Recognition& recognition) { return stated(recognition).pose_sigma[0]; }

void drive(Recognition& recognition, const WallRays::Share& share, int metres) {
  for (int i = 0; i < metres; ++i) recognition.look(share, 1.0);
}

TEST(Recognition, CountsFromTheLastWallOfTheDrawing) {
  Recognition recognition(Recognition::Drawing::FromMemory);
  drive(recognition, kNotDrawn, 60);
  EXPECT_DOUBLE_EQ(stated(recognition).unrecognised_m, 60.0);
  recognition.look({4, 0, 0, 0}, 30.0);  // hardly a wall: this says nothing
  EXPECT_DOUBLE_EQ(stated(recognition).unrecognised_m, 60.0);
  recognition.look(kMet, 1.0);
  EXPECT_DOUBLE_EQ(stated(recognition).unrecognised_m, 0.0);
}

TEST(Recognition, WhoLooksThroughDrawnWallsIsLost) {
  Recognition recognition(Recognition::Drawing::FromMemory);
  drive(recognition, kSeenThrough, 30);
  EXPECT_EQ(widened(recognition), 1.0) << "drawings are wrong in places";
  drive(recognition, kSeenThrough, 60);
  EXPECT_GT(widened(recognition), 20.0);
  recognition.look(kMet, 1.0);
  EXPECT_GT(widened(recognition), 20.0) << "one look may be a mistake";
  drive(recognition, kMet, 60);
  EXPECT_EQ(widened(recognition), 1.0);
}

/// Nobody draws all that stands along a way; but who never met anything that is drawn is elsewhere.
TEST(Recognition, AGapWithoutDrawnWallsLosesNobodyWhoWasRight) {
  Recognition right(Recognition::Drawing::FromMemory);
  drive(right, kMet, 60);
  drive(right, kNotDrawn, 400);
  EXPECT_EQ(widened(right), 1.0);
  Recognition wrong(Recognition::Drawing::FromMemory);
  drive(wrong, kNotDrawn, 400);
  EXPECT_GT(widened(wrong), 3.0);
}

TEST(Recognition, WhoIsPlacedByHandStartsAnew) {
  Recognition recognition(Recognition::Drawing::FromMemory);
  drive(recognition, kMet, 60);
  const Eigen::Matrix3d hand = Eigen::Vector3d(4.0, 4.0, 0.03).asDiagonal();
  for (int i = 0; i < 60; ++i) recognition.look(kSeenThrough, 1.0, hand);
  EXPECT_GT(widened(recognition), 5.0);
}

/// Chance lets who is elsewhere meet a wall now and then.
TEST(Recognition, ATrueMapWhoseWallsAreLookedThroughIsThatOfAnotherPlace) {
  Recognition right(Recognition::Drawing::True);
  Recognition wrong(Recognition::Drawing::True);
  for (int i = 0; i < 300; ++i) {
    right.look(i % 3 == 0 ? kNotDrawn : kMet, 1.0);
    wrong.look(i % 4 == 0 ? kMet : i % 3 == 0 ? WallRays::Share{100, 6, 9, 40} : kNotDrawn, 1.0);
  }
  EXPECT_EQ(widened(right), 1.0);
  EXPECT_GT(widened(wrong), 20.0);
}

}  // namespace
}  // namespace handmap
