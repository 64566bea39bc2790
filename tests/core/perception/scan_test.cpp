#include "core/perception/scan.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/perception/range_walls.h"

namespace handmap {
namespace {

RangePoint pointAt(double bearing_deg, double range, double z, float w) {
  const double bearing = toRadians(bearing_deg);
  return {static_cast<float>(range * std::cos(bearing)),
          static_cast<float>(range * std::sin(bearing)), static_cast<float>(z), w};
}

Scan scanOf(ScanBuilder& scans, const std::vector<RangePoint>& points) {
  return scans(points, RangeWalls(40.0, {})(points, {}));
}

const Ray* rayAt(const Scan& scan, double bearing_deg) {
  for (const Ray& ray : scan.rays) {
    if (std::abs(toDegrees(static_cast<double>(ray.bearing)) - bearing_deg) < 0.26) return &ray;
  }
  return nullptr;
}

TEST(ScanBuilder, APlanarScanKeepsLabelsAndOrder) {
  ScanBuilder scans(40.0);
  const Scan scan = scanOf(scans, {pointAt(90.0, 10.0, 1.0, 1.0F), pointAt(0.0, 5.0, 1.0, 0.0F)});
  ASSERT_EQ(scan.rays.size(), 2u);
  EXPECT_LT(scan.rays[0].bearing, scan.rays[1].bearing);
  EXPECT_FLOAT_EQ(scan.rays[0].wall, 0.0F);
  EXPECT_FLOAT_EQ(scan.rays[1].wall, 1.0F);
  EXPECT_NEAR(scan.rays[1].range, 10.0F, 1e-4F);
}

TEST(ScanBuilder, SilenceCountsOnlyWhereSomethingWasEverSeen) {
  ScanBuilder scans(40.0);
  scanOf(scans, {pointAt(90.0, 10.0, 1.0, 1.0F)});
  const Scan scan = scanOf(scans, {pointAt(0.0, 10.0, 1.0, 1.0F)});
  const Ray* silent = rayAt(scan, 90.0);
  ASSERT_NE(silent, nullptr);
  EXPECT_FALSE(silent->returned);
  EXPECT_FLOAT_EQ(silent->range, 40.0F);
  EXPECT_EQ(rayAt(scan, -90.0), nullptr);
}

TEST(ScanBuilder, BetweenTwoReturnsAStepApartNothingWasLookedAt) {
  ScanBuilder scans(40.0);
  // 1° from return to return, beginning somewhere else in each scan, as a turning head may.
  for (const double first_deg : {-90.0, -89.5, -89.2, -90.3}) {
    std::vector<RangePoint> points;
    for (int i = 0; i < 180; ++i) {
      const double bearing_deg = first_deg + i;
      if (bearing_deg < 19.0 || bearing_deg > 31.0) {
        points.push_back(pointAt(bearing_deg, 10.0, 1.0, 1.0F));
      }
    }
    const Scan scan = scanOf(scans, points);
    const auto silent = std::ranges::count_if(scan.rays, [](const Ray& r) { return !r.returned; });
    EXPECT_LE(silent, 3) << "at edges alone; nothing ever came back from 19° to 31°; " << first_deg;
    EXPECT_TRUE(first_deg == -90.0 || scan.first_looked_at.size() <= 1) << first_deg;
  }
  std::vector<RangePoint> whole;
  for (int i = 0; i < 180; ++i) whole.push_back(pointAt(-90.0 + i, 10.0, 1.0, 1.0F));
  scanOf(scans, whole);
  whole.erase(whole.begin() + 100, whole.begin() + 110);
  for (RangePoint& p : whole) {
    p = pointAt(toDegrees(static_cast<double>(std::atan2(p.y, p.x))) + 0.5, 10.0, 1.0, 1.0F);
  }
  const Scan scan = scanOf(scans, whole);
  std::vector<double> silent;
  for (const Ray& ray : scan.rays) {
    if (!ray.returned) silent.push_back(toDegrees(static_cast<double>(ray.bearing)));
  }
  const auto missing = std::ranges::count_if(silent, [](double b) { return b > 10.0 && b < 20.0; });
  EXPECT_NEAR(static_cast<double>(missing), 10.0, 1.0) << "as many as are missing";
  EXPECT_LE(silent.size() - static_cast<std::size_t>(missing), 3U) << "at edges";
}

TEST(ScanBuilder, WhatWasNotMeasuredIsNoSilence) {
  ScanBuilder scans(40.0);
  scanOf(scans, {pointAt(90.0, 10.0, 1.0, 1.0F), pointAt(0.0, 5.0, 1.0, 1.0F)});
  const Scan scan =
      scanOf(scans, {notMeasured(toRadians(90.0), 1.0F), notMeasured(toRadians(-90.0), 1.0F),
                     pointAt(45.0, 10.0, 1.0, 1.0F)});
  EXPECT_EQ(rayAt(scan, 90.0), nullptr) << "it has returned before, but was not measured now";
  ASSERT_NE(rayAt(scan, 0.0), nullptr);
  EXPECT_FALSE(rayAt(scan, 0.0)->returned) << "that is silence";
  EXPECT_EQ(scan.first_looked_at.size(), 1U);
  const Scan next = scanOf(scans, {pointAt(-90.0, 3.0, 1.0, 1.0F)});
  EXPECT_TRUE(next.first_looked_at.empty()) << "nobody knows what was there before";
  EXPECT_FALSE(rayAt(next, 90.0)->returned) << "now it is silent";
}

TEST(ScanBuilder, NorIsWhatLiesBetweenDirectionsThatWereNotMeasured) {
  ScanBuilder scans(40.0);
  std::vector<RangePoint> points;
  for (int i = 0; i < 60; ++i) points.push_back(pointAt(i, 10.0, 1.0, 1.0F));
  scanOf(scans, points);
  for (std::size_t i = 20; i < 40; ++i) {
    points[i] = notMeasured(toRadians(static_cast<double>(i)), 1.0F);
  }
  for (const Ray& ray : scanOf(scans, points).rays) EXPECT_TRUE(ray.returned) << ray.bearing;
}

TEST(ScanBuilder, AScannerThatMeasuresNothingSaysNothing) {
  ScanBuilder scans(40.0);
  scanOf(scans, {pointAt(90.0, 10.0, 1.0, 1.0F)});
  EXPECT_TRUE(scanOf(scans, {notMeasured(0.0, 1.0F)}).rays.empty());
  EXPECT_TRUE(scanOf(scans, {}).rays.empty());
}

TEST(ScanBuilder, AStandingScanLooksThroughWhatIsNoWall) {
  ScanBuilder scans(40.0);
  std::vector<RangePoint> points;
  for (int i = 0; i < 30; ++i) {
    points.push_back(pointAt(45.0, 10.0 + 0.001 * i, 0.15 * i, 1.0F));  // a wall, 4 m high
  }
  points.push_back(pointAt(-45.0, 15.0, 0.0, 1.0F));  // the ground
  const Scan scan = scanOf(scans, points);
  const Ray* wall = rayAt(scan, 45.0);
  ASSERT_NE(wall, nullptr);
  EXPECT_TRUE(wall->returned);
  EXPECT_NEAR(wall->range, 10.0F, 0.2F);
  const Ray* ground = rayAt(scan, -45.0);
  ASSERT_NE(ground, nullptr);
  EXPECT_FALSE(ground->returned);
  EXPECT_NEAR(ground->range, 15.0F, 0.01F);
}

TEST(ScanBuilder, PointsThatAreNoNumbersAreLeftOut) {
  ScanBuilder scans(40.0);
  EXPECT_TRUE(
      scanOf(scans, {{std::nanf(""), 1.0F, 1.0F, 1.0F}, {1.0F, 1e30F, 1.0F, 1.0F}}).rays.empty());
}

TEST(ScanBuilder, CornersThatAreFollowedSayNothingOfTheDirectionsBetween) {
  ScanBuilder scanner(40.0);
  ScanBuilder follower(40.0);
  RandomStream random(3);
  Scan scanned;
  Scan followed;
  for (int frame = 0; frame < 20; ++frame) {
    std::vector<RangePoint> sweep;
    std::vector<RangePoint> corners;
    const double from = random.uniform(-90.0, 0.0);
    for (int i = 0; i < 40; ++i) sweep.push_back(pointAt(from + i, 10.0, 1.0, 1.0F));
    for (int i = 0; i < 40; ++i) {
      const double bearing = random.uniform(-90.0, 90.0);
      corners.push_back(pointAt(bearing, 10.0, random.uniform(0.0, 8.0), 1.0F));
    }
    scanned = scanOf(scanner, sweep);
    followed = scanOf(follower, corners);
  }
  EXPECT_TRUE(scanned.ray_by_ray);
  EXPECT_FALSE(std::ranges::all_of(scanned.rays, &Ray::returned)) << "silence beside the sweep";
  EXPECT_FALSE(followed.ray_by_ray);
  EXPECT_TRUE(std::ranges::all_of(followed.rays, &Ray::returned));
}

TEST(Scan, LikelyWallsAreThoseOfAPlanarScanner) {
  Scan scan;
  scan.rays = {{0.0F, 5.0F, 0.1F, 0.9F, true},
               {static_cast<float>(kPi / 2.0), 7.0F, 0.1F, 0.6F, true},
               {1.7F, 6.0F, 0.1F, 0.4F, true},
               {1.8F, 9.0F, 0.0F, 0.9F, false}};
  const std::vector<RangePoint> walls = likelyWalls(scan);
  ASSERT_EQ(walls.size(), 2U) << "no hedge, and nothing where nothing came back";
  EXPECT_NEAR(walls[0].x, 5.0F, 1e-5F);
  EXPECT_NEAR(walls[1].y, 7.0F, 1e-5F);
  EXPECT_TRUE(isPlanar(walls));
}

}  // namespace
}  // namespace handmap
