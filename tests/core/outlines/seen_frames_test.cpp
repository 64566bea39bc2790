#include "core/outlines/seen_frames.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

std::vector<Echo> echoesOf(const Scan& scan) {
  SeenFrames seen(40.0);
  seen.add(0, {}, scan, {});
  std::vector<Echo> echoes;
  for (const SeenRay& ray : *seen.frames().front().rays) echoes.push_back(ray.echo);
  return echoes;
}

TEST(SeenFrames, WhatImagesShowToBeNoBuildingIsLow) {
  Scan scan;
  scan.rays = {{0.0F, 5.0F, 0.1F, 0.9F, true},
               {0.1F, 5.0F, 0.1F, 0.2F, true},
               {0.2F, 30.0F, 0.0F, 0.0F, false},
               {0.3F, 40.0F, 0.0F, 0.0F, false}};
  EXPECT_EQ(echoesOf(scan), (std::vector{Echo::Tall, Echo::Low, Echo::Ground, Echo::Silent}));
  scan.ray_by_ray = true;  // of a laser, which tells nothing of what it met
  EXPECT_EQ(echoesOf(scan), (std::vector{Echo::Tall, Echo::Tall, Echo::Ground, Echo::Silent}));
}

std::vector<Echo> echoesOf(const std::vector<RangePoint>& points) {
  SeenFrames seen(40.0);
  seen.add(0, {}, {}, points);
  std::vector<Echo> echoes;
  for (const SeenRay& ray : *seen.frames().front().rays) echoes.push_back(ray.echo);
  return echoes;
}

TEST(SeenFrames, TellsByTheirHeightWhatPointsAreFrom) {
  EXPECT_EQ(
      echoesOf({{9.0F, 0.0F, 0.1F, 1.0F}, {9.0F, 1.0F, 1.0F, 1.0F}, {9.0F, 2.0F, 2.0F, 1.0F}}),
      (std::vector{Echo::Ground, Echo::Low, Echo::Tall}));
}

TEST(SeenFrames, TheHeightOfAPlaneTellsNothing) {
  for (const float z : {0.0F, 1.0F, 2.0F}) {
    EXPECT_EQ(echoesOf({{9.0F, 0.0F, z, 1.0F}, {9.0F, 1.0F, z, 1.0F}, {9.0F, 4.0F, z, 1.0F}}),
              (std::vector{Echo::Tall, Echo::Tall, Echo::Tall}))
        << z;
  }
}

}  // namespace
}  // namespace handmap
