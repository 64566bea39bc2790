#include "core/outlines/structure.h"

#include <functional>

#include <gtest/gtest.h>

#include "tests/core/outlines/drive.h"

namespace handmap {
namespace {

const Polygon kSeenHouse = Rectangle{{20.0, 12.0}, 14.0, 8.0, 0.0}.corners();
const Polygon kHedge = Rectangle{{45.0, 9.0}, 20.0, 0.5, 0.0}.corners();

double shareOf(const PlacedRays& placed, const Polygon& near, Structure structure) {
  int all = 0;
  int such = 0;
  for (const PlacedRay& ray : placed.rays) {
    if (ray.echo != Echo::Tall || distanceTo(near, ray.end()) > 2.0) continue;
    ++all;
    such += ray.structure == structure;
  }
  return static_cast<double>(such) / std::max(1, all);
}

TEST(Structure, TellsWallsFromHedges) {
  const Drive drive = drivePast({kSeenHouse}, {kHedge});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  EXPECT_GT(shareOf(placed, kSeenHouse, Structure::Straight), 0.8);
  EXPECT_LT(shareOf(placed, kHedge, Structure::Straight), 0.2);
}

TEST(Structure, TellsAWallThatWasSeenFromFarAloneWhereRangesAreExact) {
  const Polygon far = Rectangle{{30.0, 41.0}, 30.0, 8.0, 0.0}.corners();  // its front 37 m away
  const Drive drive = drivePast({kSeenHouse, far});
  EXPECT_GT(shareOf(placeRays(drive.seen, drive.way), far, Structure::Straight), 0.8);
}

double told(const PlacedRays& placed) {
  double shares = 0.0;
  for (const PlacedRay& ray : placed.rays) shares += static_cast<double>(ray.share);
  return shares;
}

/// The drive, and `further` ones of what is kept of it.
PlacedRays drivenAgain(const Drive& drive, int further,
                       const std::function<bool(int round, const SeenRay&)>& kept) {
  std::vector<SeenFrame> seen;
  std::vector<Pose2> way;
  for (int round = 0; round <= further; ++round) {
    for (SeenFrame frame : drive.seen.frames()) {
      way.push_back(drive.way[frame.observation]);
      frame.observation = seen.size();
      std::vector<SeenRay> rays = *frame.rays;
      std::erase_if(rays, [&](const SeenRay& ray) { return !kept(round, ray); });
      frame.rays = std::make_shared<const std::vector<SeenRay>>(std::move(rays));
      seen.push_back(std::move(frame));
    }
  }
  return placeRays(seen, way);
}

TEST(Structure, FurtherRoundsTellNoMoreThanOne) {
  const Drive drive = drivePast({kSeenHouse});
  const auto all = [](int, const SeenRay&) { return true; };
  EXPECT_NEAR(told(drivenAgain(drive, 3, all)) / told(drivenAgain(drive, 0, all)), 1.0, 0.02);
}

TEST(Structure, TheOtherSideOnTheWayBackIsNews) {
  const Drive drive = drivePast({kSeenHouse});
  const auto by_side = [](int round, const SeenRay& ray) {
    return (ray.bearing >= 0.0F) == (round == 0);
  };
  const auto all = [](int, const SeenRay&) { return true; };
  EXPECT_NEAR(told(drivenAgain(drive, 1, by_side)) / told(drivenAgain(drive, 0, all)), 1.0, 0.02);
}

TEST(Structure, MeasuresTheNoiseOfReturns) {
  const Drive drive = drivePast({kSeenHouse});
  const PlacedRays placed = placeRays(drive.seen, drive.way);
  EXPECT_NEAR(placed.noise.at(10.0), 0.03, 0.03);
}

TEST(Structure, SeesNoneInReturnsFromAllOver) {
  Drive drive;
  RandomStream random(3);
  for (int i = 0; i < 40; ++i) {
    Scan scan;
    scan.ray_by_ray = true;
    for (int degree = -179; degree <= 180; ++degree) {
      scan.rays.push_back({static_cast<float>(toRadians(degree)),
                           static_cast<float>(random.uniform(3.0, 35.0)), 0.03F, 1.0F, true});
    }
    const Pose2 pose{static_cast<double>(i), 0.0, 0.0};
    drive.seen.add(drive.way.size(), pose, scan, {});
    drive.way.push_back(pose);
  }
  EXPECT_FALSE(placeRays(drive.seen, drive.way).showsStructure());
}

TEST(SeenFrames, KnowsThatSilenceWasThereBefore) {
  SeenFrames seen(40.0);
  Scan first;
  first.ray_by_ray = true;
  seen.add(0, {}, first, {});
  Scan second = first;
  second.first_looked_at = {0.5F};
  seen.add(1, {1.0, 0.0, 0.0}, second, {});
  ASSERT_EQ(seen.frames().size(), 2U);
  ASSERT_EQ(seen.frames()[0].rays->size(), 1U);
  EXPECT_EQ(seen.frames()[0].rays->front().echo, Echo::Silent);
  EXPECT_FLOAT_EQ(seen.frames()[0].rays->front().bearing, 0.5F);
  EXPECT_TRUE(seen.frames()[1].rays->empty());
}

TEST(SeenFrames, ACopyTakesNoMemoryAndStaysAsItWas) {
  SeenFrames seen(40.0);
  seen.add(0, {}, {}, std::vector<RangePoint>(500, RangePoint{5.0F, 5.0F, 2.0F, 1.0F}));
  const SeenFrames copy = seen;
  EXPECT_EQ(copy.frames()[0].rays, seen.frames()[0].rays);
  Scan later;
  later.first_looked_at = {0.5F};
  seen.add(1, {1.0, 0.0, 0.0}, later, {});
  EXPECT_EQ(seen.frames()[0].rays->size(), copy.frames()[0].rays->size() + 1);
}

TEST(SeenFrames, LeavesOutWhatWasSeenFromTheSamePlace) {
  SeenFrames seen(40.0);
  seen.add(0, {}, {}, {});
  seen.add(1, {0.1, 0.0, 0.0}, {}, {});
  seen.add(2, {0.7, 0.0, 0.0}, {}, {});
  ASSERT_EQ(seen.frames().size(), 2U);
  EXPECT_EQ(seen.frames()[1].observation, 2U);
}

TEST(SeenFrames, TakesNoMoreMemoryTheLongerTheWay) {
  constexpr std::size_t kMost = 10'000;
  SeenFrames seen(40.0, kMost);
  const std::vector<RangePoint> points(500, RangePoint{5.0F, 5.0F, 2.0F, 1.0F});
  constexpr std::size_t kObservations = 2000;
  for (std::size_t i = 0; i < kObservations; ++i) {
    seen.add(i, {0.6 * static_cast<double>(i), 0.0, 0.0}, {}, points);
    std::size_t rays = 0;
    for (const SeenFrame& frame : seen.frames()) rays += frame.rays->size();
    ASSERT_LE(rays, kMost);
  }
  EXPECT_EQ(seen.frames().front().observation, 0U);
  std::size_t farthest = 0;  // of what was kept all along the way
  for (std::size_t k = 1; k < seen.frames().size(); ++k) {
    farthest = std::max(farthest, seen.frames()[k].observation - seen.frames()[k - 1].observation);
  }
  EXPECT_GT(seen.frames().back().observation, kObservations - 200);
  EXPECT_LT(farthest, 200U);
}

TEST(SeenFrames, TellAsMuchWhenThinnedOut) {
  constexpr int kObservations = 500;
  SeenFrames all(40.0);
  SeenFrames few(40.0, 20'000);
  Scan scan;
  for (int i = 0; i < 200; ++i) {
    scan.rays.push_back({0.02F * static_cast<float>(i) - 2.0F, 10.0F, 0.1F, 1.0F, true});
  }
  std::vector<Pose2> way;
  for (int i = 0; i < kObservations; ++i) {
    way.push_back({0.6 * i, 0.0, 0.0});
    all.add(way.size() - 1, way.back(), scan, {});
    few.add(way.size() - 1, way.back(), scan, {});
  }
  EXPECT_LT(4 * few.frames().size(), all.frames().size());
  EXPECT_NEAR(told(placeRays(few.frames(), way)) / told(placeRays(all.frames(), way)), 1.0, 0.05);
}

TEST(SeenFrames, TakesSilenceFromWhatItLeavesOut) {
  SeenFrames seen(40.0);
  seen.add(0, {}, {}, {});
  Scan from_the_same_place;
  from_the_same_place.first_looked_at = {0.5F};
  seen.add(1, {0.1, 0.0, 0.0}, from_the_same_place, {});
  ASSERT_EQ(seen.frames().size(), 1U);
  EXPECT_EQ(seen.frames()[0].rays->size(), 1U);
}

}  // namespace
}  // namespace handmap
