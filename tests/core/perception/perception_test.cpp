#include "core/perception/perception.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "tests/core/base/expect_error.h"
#include "tests/core/odometry/drive.h"
#include "tests/core/perception/rendered_scene.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::render;
using test::streetCamera;

Observation observed(std::vector<View> views) {
  Observation observation;
  observation.views = std::move(views);
  return observation;
}

View pointsView(std::vector<RangePoint> points) {
  View view;
  view.points = std::move(points);
  return view;
}

View imageView(const test::Scene& scene, double pan) {
  const test::StereoPair pair = render(scene, streetCamera(), pan);
  View view;
  view.pan = pan;
  view.left = pair.left;
  view.right = pair.right;
  return view;
}

LocalMap mapOf(const Percept& percept, const LocalMapOptions& options = {}) {
  return LocalMapBuilder(40.0, options).add({}, true, percept.walls);
}

TEST(Perception, MapsRangePoints) {
  Perception perception(SourceInfo{}, {});
  const auto percept = perception(
      observed({pointsView({{5.05F, 1.05F, 0, 1}}), pointsView({{-4.05F, 0.05F, 0, 1}})}));
  const LocalMap map = mapOf(*percept);
  EXPECT_GT(map.at(5.05, 1.05), 0.0F);
  EXPECT_GT(map.at(-4.05, 0.05), 0.0F);
  EXPECT_TRUE(percept->image.empty());
  EXPECT_TRUE(percept->disparity.empty());
  EXPECT_EQ(percept->stereo_ms, 0.0);
}

TEST(Perception, APanoramaIsOneMap) {
  SourceInfo source;
  source.camera = streetCamera();
  Perception perception(source, {});
  const test::Scene scene{{{{{-3, 9}, {3, 9}}, 6.0}, {{{-3, -9}, {3, -9}}, 6.0}}, 0.0};
  Observation observation =
      observed({imageView(scene, toRadians(90.0)), imageView(scene, toRadians(-90.0))});
  observation.standing = true;
  const auto percept = perception(observation);
  const LocalMap map = mapOf(*percept);
  for (const double y : {-9.0, 9.0}) {
    float best = 0.0F;
    for (double d = -0.3; d <= 0.3; d += 0.1) {
      best = std::max(best, map.at(0.0, y + d));
    }
    EXPECT_GT(best, 0.2F) << "wall at y = " << y;
  }
  EXPECT_EQ(percept->image.data, observation.views.back().left.data);
  EXPECT_EQ(percept->disparity.cols, 621);
  EXPECT_GT(percept->stereo_ms, 0.0);
  EXPECT_GT(percept->classify_ms, 0.0);
}

TEST(Perception, WhatTwoViewsShowCountsOnce) {
  SourceInfo source;
  source.camera = streetCamera();
  const test::Scene scene{{{{{9, -6}, {9, 6}}, 6.0}}, 0.0};
  const auto votes = [&](const std::vector<double>& pans_deg) {
    Observation observation;
    observation.standing = true;
    for (const double pan : pans_deg) {
      observation.views.push_back(imageView(scene, toRadians(pan)));
    }
    return cv::sum(
        mapOf(*Perception(source, {})(observation), {.saturation_votes = 1000.0}).cells())[0];
  };
  const double once = votes({0.0});
  EXPECT_GT(once, 0.0);
  EXPECT_DOUBLE_EQ(votes({0.0, 0.0}), once);
  EXPECT_LT(votes({-10.0, 10.0}), 1.5 * once);
}

TEST(Perception, RefusesViewsThatCannotBeUsed) {
  Perception perception(SourceInfo{}, {});
  expectBadInput([&] { perception(observed({View{}})); }, {"view", "neither"});
  View images;
  images.left = images.right = cv::Mat(375, 1242, CV_8UC1, cv::Scalar(0));
  expectBadInput([&] { perception(observed({images})); }, {"images", "calibration"});
  SourceInfo source;
  source.camera = streetCamera();
  images.right = cv::Mat();
  expectBadInput([&] { Perception(source, {})(observed({images})); }, {"right image"});
}

Observation inTheYard(double x, double odometry_x) {
  Observation observation = observed({test::viewFrom(test::yard(), {x, 0.0, 0.0})});
  observation.time_s = x;
  observation.odometry = {odometry_x, 0.0, 0.0};
  return observation;
}

TEST(Perception, ImagesTellTheMotionWhateverTheOdometrySays) {
  SourceInfo source;
  source.camera = test::odometryCamera();
  Perception perception(source, {});
  EXPECT_FALSE(perception(inTheYard(0.0, 0.0))->moved) << "the first";
  const auto moved = perception(inTheYard(0.5, 3.0))->moved;
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->x, 0.5, 0.02);
  EXPECT_NEAR(moved->heading, 0.0, toRadians(0.2));
  Observation dark = inTheYard(1.0, 4.0);
  dark.views.front().left.setTo(cv::Scalar(0));
  dark.views.front().right.setTo(cv::Scalar(0));
  EXPECT_FALSE(perception(dark)->moved);
  EXPECT_FALSE(perception(inTheYard(1.5, 5.0))->moved) << "it makes up for what was guessed";
  EXPECT_TRUE(perception(inTheYard(2.0, 6.0))->moved);
}

TEST(Perception, AnOdometryOfImagesIsNotMadeAnew) {
  SourceInfo source;
  source.camera = test::odometryCamera();
  source.visual_odometry = true;
  Perception perception(source, {});
  EXPECT_FALSE(perception(inTheYard(0.0, 0.0))->moved);
  const auto moved = perception(inTheYard(0.5, 0.51))->moved;
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->x, 0.51);
  Observation guessed = inTheYard(1.0, 1.2);
  guessed.odometry_guessed = true;
  EXPECT_FALSE(perception(guessed)->moved);
}

}  // namespace
}  // namespace handmap
