#include "core/estimation/walls/evidence_window.h"

#include <deque>

#include <gtest/gtest.h>

#include "tests/core/estimation/scene.h"

namespace handmap {
namespace {

std::vector<double> cellsOf(EvidenceWindow& window) {
  std::vector<double> all;
  for (const WallImage& image : window.evidence().images()) {
    for (int column = 0; column < image.size(); ++column) {
      for (int row = 0; row < image.size(); ++row) all.push_back(image.at(column, row));
    }
  }
  return all;
}

class EvidenceWindowTest : public testing::Test {
 protected:
  EvidenceWindowTest() {
    RandomStream random(6);
    const Box box = boxOf({{0.0, 15.0}, 20.0, 8.0, 0.2});
    for (int i = 0; i < 24; ++i) {
      frames_.push_back(seenFrom({0.5 * i - 6.0, 0.0, 0.1}, {box}, 0.2, random));
    }
  }
  static EvidenceWindow window(const SensorModel& sensor) {
    EvidenceWindow window(0.5, 100.0, 60.0, 40, sensor);
    window.evidence().include(0.1, {});
    return window;
  }

  SensorModel sensor_{MeasuredSensor{}, 40.0};
  std::deque<Frame> frames_;
};

TEST_F(EvidenceWindowTest, WhatAnotherModelWeighedIsPutInAnewAFewAtATime) {
  MeasuredSensor noisy;
  noisy.noise.offset_m = 0.5;
  const SensorModel changed(noisy, 40.0);
  EvidenceWindow here = window(sensor_);
  EvidenceWindow fresh = window(changed);
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (i == 12) here.setSensor(changed);
    here.add(frames_[i]);
    fresh.add(frames_[i]);
    if (i == 13) {
      EXPECT_NE(cellsOf(here), cellsOf(fresh));
    }
  }
  EXPECT_EQ(cellsOf(here), cellsOf(fresh));
}

TEST_F(EvidenceWindowTest, FramesThatMovedFollow) {
  EvidenceWindow here = window(sensor_);
  for (std::size_t i = 0; i < 8; ++i) here.add(frames_[i]);
  for (std::size_t i = 0; i < 8; ++i) frames_[i].pose.y += 0.3;
  EvidenceWindow fresh = window(sensor_);
  for (std::size_t i = 0; i < 12; ++i) {
    if (i >= 8) here.add(frames_[i]);
    fresh.add(frames_[i]);
  }
  EXPECT_EQ(cellsOf(here), cellsOf(fresh));
}

}  // namespace
}  // namespace handmap
