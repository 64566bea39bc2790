#include "core/session/recognition.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

constexpr WallRays::Share kMet{100, 20};
constexpr WallRays::Share kNotMet{100, 2};

double widened(const Recognition& recognition) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  recognition.widen(covariance);
  return covariance(0, 0);
}

TEST(Recognition, CountsFromTheLastWallOfTheDrawing) {
  Recognition recognition;
  for (int i = 0; i < 60; ++i) recognition.look(kNotMet, 1.0);
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 60.0);
  EXPECT_EQ(widened(recognition), 1.0) << "drives between buildings are as sure as they are";
  recognition.look({4, 0}, 30.0);  // hardly a wall: this says nothing
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 60.0);
  recognition.look(kMet, 1.0);
  EXPECT_DOUBLE_EQ(recognition.unrecognised_m(), 0.0);
}

TEST(Recognition, WhoRecognisesNothingForLongIsLost) {
  Recognition recognition;
  for (int i = 0; i < 300; ++i) recognition.look(kNotMet, 1.0);
  EXPECT_GT(std::sqrt(widened(recognition)), 50.0);
  recognition.look(kMet, 1.0);
  EXPECT_GT(std::sqrt(widened(recognition)), 50.0) << "one look may be a mistake";
  for (int i = 0; i < 60; ++i) recognition.look(kMet, 1.0);
  EXPECT_EQ(widened(recognition), 1.0);
}

}  // namespace
}  // namespace handmap
