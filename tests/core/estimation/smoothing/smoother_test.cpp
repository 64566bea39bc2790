#include "core/estimation/smoothing/smoother.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/estimation/buildings/noise_estimate.h"
#include "core/estimation/smoothing/landmarks.h"
#include "core/odometry/constants.h"
#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

/// Smooths a drive past two buildings whose odometry counts `scale` metres for each, and compares
/// with the truth. Returns the scale that the smoother corrects the odometry by.
double smoothDrive(double scale) {
  RandomStream random(11);
  MeasuredSensor measured;
  measured.noise = {0.1, 0.0};
  const SensorModel sensor(measured, 40.0);
  const std::vector<Box> boxes{boxOf({{0.0, 15.0}, 20.0, 8.0, 0.0}),
                               boxOf({{10.0, -16.0}, 24.0, 10.0, 0.05})};
  std::vector<Frame> frames;
  std::vector<Pose2> truth;
  Pose2 odometry;
  for (double x = -20.0; x <= 25.0; x += 5.0) {
    const Pose2 pose{x, 0.0, 0.0};
    frames.push_back(seenFrom(pose, boxes, 0.1, random));
    if (!truth.empty()) {
      odometry =
          odometry * Pose2{5.0 * scale * random.normal(1.0, 0.01), 0.0, random.normal(0.0, 0.01)};
    }
    truth.push_back(pose);
    frames.back().odometry = odometry;
    frames.back().pose = truth.front() * odometry;
  }
  std::vector<FoundBox> found{{boxOf({{0.4, 15.3}, 19.4, 8.5, 0.01})},
                              {boxOf({{9.7, -16.3}, 24.5, 10.3, 0.03})}};
  for (std::size_t b = 0; b < 2; ++b) found[b].id = static_cast<FoundId>(b);
  std::vector<Frame*> seen;
  for (Frame& frame : frames) seen.push_back(&frame);
  std::vector<Vec2> landmarks;
  OdometryNoise noise = kWheels;
  noise.along_per_m = 0.01;
  Smoother smoother(noise, sensor);
  const SmoothingGraph graph{seen, 1, found, landmarks};
  // As many as in a run: the scale follows slowly.
  for (int i = 0; i < 30; ++i) smoother.iterate(graph, i < 20 ? 0.5 : 0.1);
  for (int i = 0; i < 5; ++i) smoother.iterate(graph, 0.03);
  smoother.covariances(found);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_LT((frames[i].pose.position() - truth[i].position()).norm(), 0.3) << i;
    EXPECT_NEAR(frames[i].pose.heading, truth[i].heading, 0.01) << i;
  }
  for (std::size_t b = 0; b < 2; ++b) {
    const Rectangle r = found[b].box.rectangle();
    EXPECT_NEAR(r.width, boxes[b].rectangle().width, 0.4);
    EXPECT_NEAR(r.centre.x(), boxes[b].rectangle().centre.x(), 0.3);
    EXPECT_GT(found[b].observations, 5);
    EXPECT_LT(found[b].reachSigma(b == 0 ? 3 : 1), 0.2);  // the fronts
  }
  return smoother.scaled({1.0, 0.0, 0.0}).x;
}

TEST(Smoother, BringsPosesAndBoxesBack) { EXPECT_NEAR(smoothDrive(1.0), 1.0, 0.01); }

TEST(Smoother, FindsTheScaleOfTheOdometry) { EXPECT_NEAR(smoothDrive(1.03), 1.0 / 1.03, 0.008); }

/// What a graph of one box holds, to be broken.
struct Small {
  Small() : sensor(MeasuredSensor{}, 40.0), smoother(kWheels, sensor) {
    RandomStream random(5);
    const std::vector<Box> boxes{boxOf({{0.0, 15.0}, 20.0, 8.0, 0.0})};
    for (double x = -6.0; x <= 6.0; x += 3.0) {
      frames.push_back(seenFrom({x, 0.0, 0.0}, boxes, 0.1, random));
    }
    for (Frame& frame : frames) pointers.push_back(&frame);
    found.push_back({boxOf({{0.5, 15.2}, 19.0, 8.0, 0.0})});
    found.front().id = FoundId{0};
  }
  double iterate() { return smoother.iterate({pointers, 1, found, landmarks}, 0.1); }

  SensorModel sensor;
  Smoother smoother;
  std::vector<Frame> frames;
  std::vector<Frame*> pointers;
  std::vector<FoundBox> found;
  std::vector<Vec2> landmarks;
};

TEST(Smoother, WhatHasNoSolutionLeavesAllAsItWas) {
  Small small;
  EXPECT_GT(small.iterate(), 0.0);
  const FoundBox before = small.found.front();
  const Pose2 last = small.frames.back().pose;
  const double none = std::numeric_limits<double>::quiet_NaN();
  small.frames[2].odometry.x = none;
  EXPECT_EQ(small.iterate(), 0.0);
  EXPECT_EQ(small.found.front().box.reach, before.box.reach);
  EXPECT_EQ(small.found.front().box.heading, before.box.heading);
  EXPECT_EQ(small.found.front().observations, before.observations);
  EXPECT_EQ(small.frames.back().pose, last);
  EXPECT_TRUE(std::isfinite(small.smoother.scaled({1.0, 0.0, 0.0}).x));
  // Nor is there a covariance of it; what was known of the walls stays.
  EXPECT_FALSE(small.smoother.covariances(small.found).has_value());
  EXPECT_EQ(small.found.front().covariance, before.covariance);
  small.frames[2].odometry.x = 0.0;
  EXPECT_GT(small.iterate(), 0.0);
  EXPECT_TRUE(small.smoother.covariances(small.found).has_value());
}

TEST(Smoother, AStopLeavesAllAsItWas) {
  Small small;
  std::stop_source stop;
  stop.request_stop();
  const Box before = small.found.front().box;
  EXPECT_EQ(small.smoother.iterate({small.pointers, 1, small.found, small.landmarks}, 0.1,
                                   stop.get_token()),
            0.0);
  EXPECT_EQ(small.found.front().box.reach, before.reach);
}

TEST(Smoother, ABoxThatNobodySeesStaysAndTurnsLittle) {
  Small small;
  small.found.push_back({boxOf({{0.0, 300.0}, 20.0, 8.0, 0.0})});
  small.found.back().id = FoundId{1};
  const Box before = small.found.back().box;
  for (int i = 0; i < 5; ++i) small.iterate();
  EXPECT_EQ(small.found.back().observations, 0);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(small.found.back().box.reach[k], before.reach[k], 1e-9);
  }
}

TEST(Landmarks, ATreeIsSeenAtItsMiddleFromEverywhere) {
  const SensorModel sensor(MeasuredSensor{}, 40.0);
  const Vec2 tree(8.0, 6.0);
  Landmarks landmarks;
  for (double x = 0.0; x <= 15.0; x += 3.0) {
    const Pose2 pose{x, 0.0, 0.2};
    Scan scan;
    for (int i = 0; i < 720; ++i) {
      const double bearing = -kPi + 2.0 * kPi * (i + 1) / 720;
      const Vec2 to_tree = tree - pose.position();
      const Vec2 direction = unitVector(pose.heading + bearing);
      const double nearest = to_tree.dot(direction);
      const double squared = 0.49 - to_tree.squaredNorm() + nearest * nearest;
      const bool hit = nearest > 0.0 && squared > 0.0;
      const double range = hit ? nearest - std::sqrt(squared) : 40.0;
      scan.rays.push_back(
          {static_cast<float>(bearing), static_cast<float>(range), 0.0F, 0.0F, hit});
    }
    Frame frame = makeFrame(0.0, pose, pose, scan);
    frame.sightings = compactThings(frame.rays, sensor);
    ASSERT_EQ(frame.sightings.size(), 1u);
    landmarks.associate(frame, sensor.measured().noise, 40);
    const Sighting& s = frame.sightings.front();
    EXPECT_LT((pose.toOuter(s.range * unitVector(s.bearing)) - tree).norm(), 0.25);
  }
  EXPECT_EQ(landmarks.positions().size(), 1u);
}

TEST(NoiseEstimate, FindsTheNoiseThatTheDataHave) {
  RandomStream random(12);
  MeasuredSensor measured;
  measured.noise = {0.15, 0.0};
  const Box box = boxOf({{0.0, 15.0}, 40.0, 8.0, 0.0});
  const std::vector<FoundBox> found{{box}};
  NoiseEstimate estimate;
  for (int round = 0; round < 12; ++round) {
    const SensorModel sensor(measured, 40.0);
    for (double x = -10.0; x <= 10.0; x += 5.0) {
      estimate.add(seenFrom({x, 0.0, 0.0}, {box}, 0.3, random), found, sensor);
      estimate.add(seenFrom({x, 5.0, 0.0}, {box}, 0.3, random), found, sensor);
    }
    measured.noise = estimate.fitted(measured.noise);
  }
  EXPECT_NEAR(measured.noise.at(10.0), 0.3, 0.06);
  EXPECT_TRUE(differMuch(measured.noise, {0.15, 0.0}));
}

}  // namespace
}  // namespace handmap
