#include "core/explain/wall_story.h"

#include <numeric>

#include <gtest/gtest.h>

namespace handmap {
namespace {

/// A robot drives along y = 0 by a building whose lower wall (wall 0) lies at y = 10, drawn at 13.
class WallStoryTest : public testing::Test {
 protected:
  WallStoryTest() {
    Building building;
    building.id = "N1";
    building.shape = Rectangle{{20.0, 15.0}, 20.0, 10.0, 0.0};
    building.estimate = Estimate{0.2, 0.2, 0.2, 9};
    refined_.buildings = {building};
    building.shape = Rectangle{{20.0, 18.0}, 20.0, 10.0, 0.0};
    building.uncertainty = Uncertainty{3.0, 0.0};
    drawing_.buildings = {building};
    for (int i = 0; i <= 40; ++i) {
      const Pose2 pose{static_cast<double>(i), 0.0, 0.3};
      way_.push_back({0.1 * i, pose});
      scans_.push_back(looking(pose, 10.1));
    }
  }

  /// Rays to all sides; those that look up end on a line at y = `wall`.
  static Scan looking(const Pose2& pose, double wall) {
    Scan scan;
    for (int degrees = -170; degrees < 180; degrees += 5) {
      Ray ray;
      ray.bearing = static_cast<float>(toRadians(degrees));
      ray.sigma = 0.02F;
      ray.wall = 1.0F;
      const double up = std::sin(pose.heading + toRadians(degrees));
      ray.returned = up > 0.3;
      ray.range = static_cast<float>(ray.returned ? wall / up : 40.0);
      scan.rays.push_back(ray);
    }
    return scan;
  }
  std::vector<SeenScan> seen() const {
    std::vector<SeenScan> seen;
    for (std::size_t i = 0; i < scans_.size(); ++i) seen.push_back({way_[i].time_s, &scans_[i]});
    return seen;
  }
  static std::size_t lowerWall(const Map& map) {
    const Polygon outline = map.buildings[0].footprint();
    for (std::size_t i = 0; i < 4; ++i) {
      if (outline[i].y() < 14.0 && outline[(i + 1) % 4].y() < 14.0) return i;
    }
    return 4;
  }
  WallStory story(std::size_t wall) const {
    return storyOf(drawing_, refined_, way_, seen(), 0, wall);
  }

  Map drawing_;
  Map refined_;
  std::vector<StampedPose> way_;
  std::vector<Scan> scans_;
};

TEST_F(WallStoryTest, TellsWhereTheRaysFellAndWhatTheDrawingSaid) {
  const WallStory told = story(lowerWall(refined_));
  EXPECT_NEAR(told.drawn_m, -3.0, 1e-9);  // inwards: the outward side is down
  EXPECT_NEAR(told.drawn_sigma_m, 3.0, 1e-3);
  ASSERT_GT(told.witnesses.size(), 20U);
  std::size_t rays = 0;
  for (const WallWitness& witness : told.witnesses) {
    rays += witness.returns.size();
    EXPECT_NEAR(witness.offset_m, -0.1, 1e-4);
    for (const Vec2& end : witness.returns) {
      EXPECT_GE(end.x(), 10.0);
      EXPECT_LE(end.x(), 30.0);
    }
  }
  EXPECT_EQ(told.rays, rays);
  EXPECT_NEAR(told.seen_m, -0.1, 1e-4);
  EXPECT_GT(told.seen_sigma_m, 0.01);
  EXPECT_LT(told.seen_sigma_m, 0.2);
}

TEST_F(WallStoryTest, WeightsAndPullsAddUp) {
  const WallStory told = story(lowerWall(refined_));
  double shares = told.drawn_share;
  double at = told.drawn_m;
  for (const WallWitness& witness : told.witnesses) {
    shares += witness.share;
    at += witness.pull_m;
  }
  EXPECT_NEAR(shares, 1.0, 1e-9);
  EXPECT_NEAR(at, told.explained_m, 1e-9);
  EXPECT_NEAR(told.explained_m, -0.1, 0.05);
  EXPECT_TRUE(std::ranges::is_sorted(told.witnesses, std::greater(), &WallWitness::share));
}

TEST_F(WallStoryTest, ManyLooksFromOneMetreAreOne) {
  const double moving = story(lowerWall(refined_)).seen_sigma_m;
  // Ten times as often, over the same way.
  std::vector<StampedPose> way;
  std::vector<Scan> scans;
  for (int i = 0; i <= 400; ++i) {
    const Pose2 pose{0.1 * i, 0.0, 0.3};
    way.push_back({0.01 * i, pose});
    scans.push_back(looking(pose, 10.1));
  }
  way_ = way;
  scans_ = scans;
  EXPECT_NEAR(story(lowerWall(refined_)).seen_sigma_m, moving, 0.2 * moving);
}

TEST_F(WallStoryTest, AWallThatNobodySawHasNoWitness) {
  const WallStory told = story((lowerWall(refined_) + 2) % 4);
  EXPECT_TRUE(told.witnesses.empty());
  EXPECT_EQ(told.rays, 0U);
  EXPECT_EQ(told.drawn_share, 1.0);
  EXPECT_EQ(told.explained_m, told.drawn_m);
}

TEST_F(WallStoryTest, WhatIsNotOfTheWallTellsNothing) {
  const std::size_t wall = lowerWall(refined_);
  const std::size_t rays = story(wall).rays;
  for (Scan& scan : scans_) {
    for (Ray& ray : scan.rays) ray.wall = 0.0F;  // no wall of a building
  }
  EXPECT_TRUE(story(wall).witnesses.empty());
  for (Scan& scan : scans_) scan = looking({0.0, 0.0, 0.3}, 8.0);  // a hedge 2 m in front
  EXPECT_TRUE(story(wall).witnesses.empty());
  EXPECT_GT(rays, 0U);
}

TEST_F(WallStoryTest, TimesOutsideOfTheWayAndWallsThatAreNotThereAreBorne) {
  const Scan scan = looking({20.0, 0.0, 0.0}, 10.0);
  const std::vector<SeenScan> seen = {{-5.0, &scan}, {99.0, &scan}, {1.0, nullptr}};
  const std::size_t wall = lowerWall(refined_);
  EXPECT_TRUE(storyOf(drawing_, refined_, way_, seen, 0, wall).witnesses.empty());
  EXPECT_TRUE(storyOf(drawing_, refined_, {}, seen, 0, wall).witnesses.empty());
  EXPECT_EQ(storyOf(drawing_, refined_, way_, seen, 7, 0).wall.length(), 0.0);
  EXPECT_EQ(storyOf(drawing_, refined_, way_, seen, 0, 9).wall.length(), 0.0);
}

}  // namespace
}  // namespace handmap
