#include "core/perception/stereo_walls.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/base/expect_error.h"
#include "tests/core/perception/rendered_scene.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::render;
using test::Scene;
using test::StereoPair;
using test::streetCamera;

constexpr double kStereoRange_m = 40.0;

Scene wall(const Vec2& a, const Vec2& b, double height = 6.0) { return {{{{a, b}, height}}, 0.0}; }

std::vector<WallPoint> wallsIn(const Scene& scene, const StereoCamera& camera, double pan = 0.0,
                               const StereoOptions& options = {}) {
  const StereoPair pair = render(scene, camera, pan);
  return StereoWalls(camera, options)(pair.left, pair.right, pan, kStereoRange_m).walls;
}

struct Errors {
  std::size_t points = 0;
  double mean_m = 0.0;          ///< of the distances from the segment
  double within_2_sigma = 0.0;  ///< share
};

Errors errorsFrom(const Segment& truth, const std::vector<WallPoint>& walls) {
  Errors errors{.points = walls.size()};
  for (const WallPoint& wall : walls) {
    const double distance = distanceTo(truth, Vec2(wall.x, wall.y));
    const auto count = static_cast<double>(walls.size());
    errors.mean_m += distance / count;
    if (distance < 2.0 * static_cast<double>(wall.sigma)) errors.within_2_sigma += 1.0 / count;
  }
  return errors;
}

TEST(StereoWalls, FindsAFrontWallWhereItIs) {
  const Segment truth{{10, -4}, {10, 4}};
  const Errors errors = errorsFrom(truth, wallsIn(wall(truth.a, truth.b), streetCamera()));
  EXPECT_GT(errors.points, 250u);  // of the 289 columns that it fills
  EXPECT_LT(errors.mean_m, 0.13);  // the matcher draws disparities to whole pixels
  EXPECT_GT(errors.within_2_sigma, 0.98);
}

TEST(StereoWalls, FindsAWallAtAGrazingAngle) {
  const Segment truth{{7, 5}, {22, 6}};
  const Errors errors = errorsFrom(truth, wallsIn(wall(truth.a, truth.b), streetCamera()));
  EXPECT_GT(errors.points, 100u);
  EXPECT_LT(errors.mean_m, 0.1);
  EXPECT_GT(errors.within_2_sigma, 0.95);
}

TEST(StereoWalls, SeesBothWallsOfOneColumn) {
  // A 3 m fence 8 m ahead and a high house behind it.
  const Scene scene{{{{{8, -3}, {8, 3}}, 3.0}, {{{20, -8}, {20, 8}}, 12.0}}, 0.0};
  int near = 0;
  int far = 0;
  for (const WallPoint& point : wallsIn(scene, streetCamera())) {
    if (std::abs(point.y) > 2.5F) continue;
    near += std::abs(point.x - 8.0F) < 0.3F;
    far += std::abs(point.x - 20.0F) < 1.0F;
  }
  EXPECT_GT(near, 150);
  EXPECT_GT(far, 50);
}

TEST(StereoWalls, LeavesOutTheGroundAndLowThings) {
  const Scene scene{{{{{8, -4}, {8, 4}}, 1.6}, {{{15, -9}, {15, 9}}, 1.2}}, 0.0};
  EXPECT_TRUE(wallsIn(scene, streetCamera()).empty());
}

TEST(StereoWalls, FollowsASlopingGround) {
  // On a street that climbs by 5 % the top of a car of 1.6 m is 2.6 m above the robot.
  Scene scene{{{{{20, -8}, {20, 8}}, 2.6}}, 0.05};
  EXPECT_TRUE(wallsIn(scene, streetCamera()).empty());
  scene.ground_slope = 0.0;
  StereoOptions options;
  options.filter.min_extent_m = 0.5;
  EXPECT_FALSE(wallsIn(scene, streetCamera(), 0.0, options).empty());
}

TEST(StereoWalls, KeepsTheLeftEdgeOfTheView) {
  const auto walls = wallsIn(wall({14, -20}, {14, 20}), streetCamera());
  double leftmost = 0.0;
  for (const WallPoint& point : walls) {
    leftmost = std::max(leftmost, static_cast<double>(point.y / point.x));
  }
  // The first columns see the wall only with the left camera: 28 of 1242 pixels.
  EXPECT_GT(leftmost, (609.6 - 50.0) / 721.5);
}

TEST(StereoWalls, AppliesMountAndPan) {
  StereoCamera camera = streetCamera();
  camera.mount = {0.5, -0.3, 1.2, toRadians(-6.0), toRadians(20.0)};
  const Segment truth{{-4, 9}, {4, 9}};
  const auto walls = wallsIn(wall(truth.a, truth.b, 8.0), camera, toRadians(70.0));
  const Errors errors = errorsFrom(truth, walls);
  ASSERT_GT(errors.points, 250u);
  EXPECT_LT(errors.mean_m, 0.06);
  const auto [low, high] = std::minmax_element(
      walls.begin(), walls.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  EXPECT_NEAR(low->x, -4.0, 0.2);
  EXPECT_NEAR(high->x, 4.0, 0.2);
}

TEST(StereoWalls, NoiseGrowsWithTheSquareOfTheRangeAndEndsTheView) {
  const auto sigma_at = [](double x) {
    const auto walls = wallsIn(wall({x, -3}, {x, 3}), streetCamera());
    return walls.empty() ? 0.0 : static_cast<double>(walls[walls.size() / 2].sigma);
  };
  const double expected = 10.0 * 10.0 * 0.25 / (0.5 * 721.5 * 0.537);
  EXPECT_NEAR(sigma_at(10.0), expected, 0.02);
  EXPECT_NEAR(sigma_at(20.0), 4.0 * expected, 0.08);
  EXPECT_EQ(sigma_at(32.0), 0.0);  // σ > 1 m
}

TEST(StereoWalls, CoveredOrUnrelatedImagesGiveNoWalls) {
  StereoWalls stereo(streetCamera(), {});
  const cv::Mat grey(375, 1242, CV_8UC1, cv::Scalar(90));
  const cv::Mat white(375, 1242, CV_8UC1, cv::Scalar(255));
  const StereoPair pair = render(wall({10, -4}, {10, 4}), streetCamera());
  EXPECT_TRUE(stereo(grey, grey, 0.0, kStereoRange_m).walls.empty());
  EXPECT_TRUE(stereo(white, white, 0.0, kStereoRange_m).walls.empty());
  EXPECT_TRUE(stereo(pair.left, grey, 0.0, kStereoRange_m).walls.empty());
  EXPECT_TRUE(stereo(grey, pair.right, 0.0, kStereoRange_m).walls.empty());
}

TEST(StereoWalls, ColourIsAsGoodAsGreyAndRunsAreEqual) {
  const StereoPair pair = render(wall({9, -4}, {11, 4}), streetCamera());
  cv::Mat left;
  cv::Mat right;
  cv::cvtColor(pair.left, left, cv::COLOR_GRAY2BGR);
  cv::cvtColor(pair.right, right, cv::COLOR_GRAY2BGR);
  StereoWalls stereo(streetCamera(), {});
  const auto first = stereo(pair.left, pair.right, 0.0, kStereoRange_m).walls;
  const int threads = cv::getNumThreads();
  cv::setNumThreads(1);
  const auto second = stereo(left, right, 0.0, kStereoRange_m).walls;
  cv::setNumThreads(threads);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].x, second[i].x);
    EXPECT_EQ(first[i].y, second[i].y);
  }
}

TEST(StereoWalls, RefusesBadImages) {
  StereoWalls stereo(streetCamera(), {});
  const cv::Mat good(375, 1242, CV_8UC1, cv::Scalar(0));
  const auto pair = [&](const cv::Mat& left, const cv::Mat& right) {
    return [&stereo, left, right] { stereo(left, right, 0.0, kStereoRange_m); };
  };
  expectBadInput(pair(cv::Mat(), good), {"left image", "no image"});
  expectBadInput(pair(good, cv::Mat()), {"right image", "no image"});
  expectBadInput(pair(good, good.colRange(0, 1000)), {"right image", "1000×375", "1242×375"});
  expectBadInput(pair(cv::Mat(375, 1242, CV_16UC1, cv::Scalar(0)), good), {"16 bits"});
  expectBadInput(pair(good, cv::Mat(375, 1242, CV_8UC4, cv::Scalar(0))), {"4 channels"});
  const cv::Mat tiny(20, 20, CV_8UC1, cv::Scalar(0));
  expectBadInput(pair(tiny, tiny), {"20×20", "at least"});
}

TEST(StereoWalls, RefusesBadCamerasAndOptions) {
  const auto camera = [](auto change) {
    return [change] {
      StereoCamera bad = streetCamera();
      change(bad);
      StereoWalls(bad, {});
    };
  };
  expectBadInput(camera([](StereoCamera& c) { c.baseline = 0.0; }), {"baseline", "0"});
  expectBadInput(camera([](StereoCamera& c) { c.baseline = -0.5; }), {"baseline", "-0.5"});
  expectBadInput(camera([](StereoCamera& c) { c.fx = std::nan(""); }), {"fx"});
  expectBadInput(camera([](StereoCamera& c) { c.cx = INFINITY; }), {"camera"});
  expectBadInput(camera([](StereoCamera& c) { c.mount.pitch = 1.5; }), {"pitch"});
  const auto options = [](auto change) {
    return [change] {
      StereoOptions bad;
      change(bad);
      StereoWalls(streetCamera(), bad);
    };
  };
  expectBadInput(options([](StereoOptions& o) { o.scale = -0.5; }), {"scale"});
  expectBadInput(options([](StereoOptions& o) { o.num_disparities = 20; }), {"num_disparities"});
  expectBadInput(options([](StereoOptions& o) { o.block_size = 4; }), {"block_size"});
}

}  // namespace
}  // namespace handmap
