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

}  // namespace
}  // namespace handmap
