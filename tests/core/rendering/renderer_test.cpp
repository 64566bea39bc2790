#include "core/rendering/renderer.h"

#include <map>
#include <set>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <tbb/global_control.h>

#include "tests/core/base/expect_error.h"
#include "tests/core/rendering/views.h"

namespace handmap {
namespace {

using test::box;
using test::worldOf;

/// A wall 12 m ahead, as far as one sees.
World wallAhead() { return worldOf({box("W", {{15.0, 0.0}, 60.0, 6.0, kPi / 2.0})}); }

TEST(Renderer, DisparityOfAWallIsFocalLengthTimesBaselineOverDepth) {
  RenderOptions options;
  options.noise_sigma = 0.0;
  options.exposure = 0.6;
  const Renderer renderer(options, 1);
  const World world = wallAhead();
  const Scene scene = renderer.sceneAt(world, Pose2{}, 0.0);
  const StereoImages images = renderer.images(scene, Pose2{}, 0.0, 0, 0);
  const StereoCamera& camera = renderer.camera();
  const double expected = camera.fx * camera.baseline / 12.0;
  // The upper half of a strip of the wall, matched whole and to a fraction of a pixel.
  const cv::Rect patch(200, 120, 240, 80);
  cv::Mat score;
  const cv::Rect search(patch.x - 50, patch.y, patch.width + 45, patch.height);
  cv::matchTemplate(images.right(search), images.left(patch), score, cv::TM_CCOEFF_NORMED);
  cv::Point best;
  double most = 0.0;
  cv::minMaxLoc(score, nullptr, &most, nullptr, &best);
  ASSERT_GT(best.x, 0);
  ASSERT_LT(best.x, score.cols - 1);
  const float* at = score.ptr<float>() + best.x;
  const double fraction =
      0.5 * static_cast<double>((at[-1] - at[1]) / (at[-1] + at[1] - 2 * at[0]));
  EXPECT_GT(most, 0.95);
  EXPECT_NEAR(50.0 - best.x - fraction, expected, 0.05);
}

TEST(Renderer, DepthAndLabelsAgreeWithTheWorld) {
  const Renderer renderer(test::smallCamera(), 1);
  const Pose2 pose{1.0, 0.5, 0.1};
  const World world = wallAhead();
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, pose, 0.0), pose, 0.05);
  const ViewCamera camera = viewCamera(renderer.camera(), 160, 120, pose, 0.05);
  int walls = 0;
  int grounds = 0;
  for (int row = 0; row < 120; ++row) {
    for (int column = 0; column < 160; ++column) {
      const Vec3 ray = camera.ray(column, row);
      const auto label = static_cast<Label>(truth.labels(row, column));
      const auto depth = static_cast<double>(truth.depth(row, column));
      const Vec3 place = camera.eye + depth * ray;
      if (label == Label::Building && place.z() < 2.0) {
        ++walls;
        ASSERT_NEAR(place.x(), 12.0, 1e-3);
      } else if (label == Label::Road || label == Label::Pavement) {
        ++grounds;
        ASSERT_NEAR(place.z(), 0.0, 1e-3);
        ASSERT_EQ(label == Label::Road, std::abs(place.y()) < 4.0) << place.transpose();
      } else if (label == Label::Sky) {
        ASSERT_EQ(depth, std::numeric_limits<double>::infinity());
        ASSERT_GT(ray.z(), 0.0);
      }
    }
  }
  EXPECT_GT(walls, 2000);
  EXPECT_GT(grounds, 1000);
}

TEST(Renderer, CarsHedgesAndTreesAreSeenAndLabelled) {
  World world = wallAhead();
  world.things = {{Thing::Kind::Car, {{8.0, 2.0}, 4.2, 1.7, 0.0}, 1.5},
                  {Thing::Kind::Hedge, {{9.0, -4.0}, 1.0, 4.0, 0.0}, 1.2}};
  world.obstacles = {{{9.0, 5.5}, 0.4}};
  const Renderer renderer(test::smallCamera(), 1);
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0);
  const ViewCamera camera = viewCamera(renderer.camera(), 160, 120, Pose2{}, 0.0);
  const auto at = [&](double x, double y, double z) {
    const double forward = x;
    const int column = static_cast<int>(std::lround(camera.cx - camera.fx * y / forward));
    const int row = static_cast<int>(std::lround(camera.cy - camera.fy * (z - 1.5) / forward));
    return std::pair(static_cast<Label>(truth.labels(row, column)), truth.depth(row, column));
  };
  EXPECT_EQ(at(5.9, 2.0, 0.5), std::pair(Label::Car, at(5.9, 2.0, 0.5).second));
  EXPECT_NEAR(at(5.9, 2.0, 0.5).second, 5.9F, 0.01F);
  EXPECT_EQ(at(8.5, -4.0, 0.6).first, Label::Tree);
  EXPECT_NEAR(at(8.5, -4.0, 0.6).second, 8.5F, 0.25F);
  EXPECT_EQ(at(9.0, 5.5, 4.0).first, Label::Tree);
  EXPECT_EQ(at(12.0, 0.0, 2.0).first, Label::Building);
}

TEST(Renderer, PeopleSignsAndLampsAreSeenAndLabelled) {
  World world = wallAhead();
  world.things = {{Thing::Kind::Person, {{6.0, 0.0}, 0.3, 0.5, kPi}, 1.8},
                  {Thing::Kind::Sign, {{6.0, 2.0}, 0.07, 0.07, kPi}, 2.6},
                  {Thing::Kind::Lamp, {{6.0, -2.0}, 0.16, 0.16, 0.0}, 6.0}};
  const Renderer renderer(RenderOptions{}, 1);
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0);
  const ViewCamera camera = viewCamera(renderer.camera(), 640, 480, Pose2{}, 0.0);
  const auto at = [&](double y, double z) {
    const double pixels = camera.fx / 6.0;
    const int column = static_cast<int>(std::lround(camera.cx - pixels * y));
    const int row = static_cast<int>(std::lround(camera.cy - pixels * (z - 1.5)));
    return static_cast<Label>(truth.labels(row, column));
  };
  EXPECT_EQ(at(0.0, 1.2), Label::Pedestrian);
  EXPECT_EQ(at(0.0, 1.7), Label::Pedestrian);
  EXPECT_NE(at(0.0, 1.95), Label::Pedestrian);
  EXPECT_EQ(at(2.0, 2.25), Label::Sign);
  EXPECT_EQ(at(2.0, 1.0), Label::Pole);
  EXPECT_EQ(at(-2.0, 2.5), Label::Pole);
}

TEST(Renderer, FencesAndBicyclesAreSeenAndSeenThrough) {
  World world = wallAhead();
  world.things = {{Thing::Kind::Fence, {{6.0, 1.6}, 2.2, 0.06, kPi / 2.0}, 1.4, 0.06},
                  {Thing::Kind::Rack, {{7.0, -2.0}, 3.0, 1.8, kPi / 2.0}, 1.1, 2.0}};
  const Renderer renderer(RenderOptions{}, 1);
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0);
  const ViewCamera camera = viewCamera(renderer.camera(), 640, 480, Pose2{}, 0.0);
  std::map<Label, int> before_fence;
  std::map<Label, int> before_rack;
  for (int row = 0; row < 480; ++row) {
    for (int column = 0; column < 640; ++column) {
      const Vec3 ray = camera.ray(column, row);
      const Vec3 at_fence = camera.eye + 6.0 / ray.x() * ray;
      const Vec3 at_rack = camera.eye + 7.0 / ray.x() * ray;
      const auto label = static_cast<Label>(truth.labels(row, column));
      if (std::abs(at_fence.y() - 1.6) < 1.0 && at_fence.z() > 0.3 && at_fence.z() < 1.15) {
        ++before_fence[label];
        const float depth = truth.depth(row, column);
        if (label == Label::Fence) {
          EXPECT_NEAR(depth, 6.0F, 0.1F);
        }
      }
      if (std::abs(at_rack.y() + 2.0) < 1.4 && at_rack.z() > 0.1 && at_rack.z() < 0.9) {
        ++before_rack[label];
      }
    }
  }
  const double seen = before_fence[Label::Fence];
  const double behind = before_fence[Label::Building] + before_fence[Label::Pavement] +
                        before_fence[Label::Road] + before_fence[Label::Tree];
  EXPECT_NEAR(seen / (seen + behind), 1.0 - std::exp(-1.0), 0.1);  // what its free path says
  EXPECT_GT(before_rack[Label::Bicyclist], 300);
  EXPECT_GT(before_rack[Label::Building], before_rack[Label::Bicyclist]);
}

TEST(Renderer, ARecessIsAsDeepAsTheWallsSay) {
  World world = wallAhead();
  world.walls = {
      Polygon{{12, 30}, {12, 1}, {13, 1}, {13, -1}, {12, -1}, {12, -30}, {18, -30}, {18, 30}}};
  const Renderer renderer(test::smallCamera(), 1);
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0);
  const ViewCamera camera = viewCamera(renderer.camera(), 160, 120, Pose2{}, 0.0);
  const int row = static_cast<int>(std::lround(camera.cy));
  const auto depth_at = [&](double y) {
    return truth.depth(row, static_cast<int>(std::lround(camera.cx - camera.fx * y / 12.0)));
  };
  EXPECT_NEAR(depth_at(0.0), 13.0F, 1e-3F);
  EXPECT_NEAR(depth_at(3.0), 12.0F, 1e-3F);
}

TEST(Renderer, AHouseShadesTheWallBehindIt) {
  World world = wallAhead();
  world.map.buildings.push_back(box("S", {{-8.0, 12.0}, 8.0, 8.0, 0.0}));  // out of the picture
  const auto left = [&](double azimuth_deg) {
    RenderOptions options = test::smallCamera();
    options.light.sun_azimuth_deg = azimuth_deg;
    options.light.sun_elevation_deg = 8.0;
    options.light.cloud_share = 0.0;
    options.noise_sigma = 0.0;
    const Renderer renderer(options, 1);
    return renderer.images(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0, 0, 0).left;
  };
  const World alone = wallAhead();
  const double azimuth = toDegrees(std::atan2(12.0, -8.0 - 12.0));  // the sun behind the house
  const cv::Mat shaded = left(azimuth);
  world = alone;
  const cv::Mat sunny = left(azimuth);
  EXPECT_GT(cv::norm(shaded, sunny, cv::NORM_L1) / (160 * 120), 5.0);  // grey levels
}

TEST(Renderer, FollowsFromItsSeedsOnAnyNumberOfThreads) {
  const World world = streetWorld(4);
  const Pose2 pose{30.0, 0.0, 0.2};
  const auto render = [&](int threads, std::uint64_t seed) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    RenderOptions options = test::smallCamera();
    options.colour = true;
    const Renderer renderer(options, seed);
    const Scene scene = renderer.sceneAt(world, pose, 7.0);
    const StereoImages images = renderer.images(scene, pose, 0.0, 3, 1);
    cv::Mat both;
    cv::hconcat(images.left, images.right, both);
    return both;
  };
  const cv::Mat once = render(1, 1);
  EXPECT_EQ(cv::norm(once, render(2, 1), cv::NORM_INF), 0.0);
  const double other_noise = cv::norm(once, render(2, 2), cv::NORM_INF);
  EXPECT_GT(other_noise, 0.0);
  EXPECT_LT(other_noise, 20.0);
}

TEST(Renderer, NoiseIsWhatTheOptionsSay) {
  const World world = wallAhead();
  RenderOptions options = test::smallCamera();
  options.exposure = 0.5;
  const auto left = [&](double sigma) {
    options.noise_sigma = sigma;
    const Renderer renderer(options, 1);
    return renderer.images(renderer.sceneAt(world, Pose2{}, 0.0), Pose2{}, 0.0, 0, 0).left;
  };
  cv::Mat difference;
  cv::subtract(left(4.0), left(0.0), difference, cv::noArray(), CV_32F);
  cv::Scalar mean;
  cv::Scalar sigma;
  cv::meanStdDev(difference, mean, sigma);
  EXPECT_NEAR(mean[0], 0.0, 0.15);
  EXPECT_NEAR(sigma[0], 4.0, 0.15);
}

TEST(Renderer, LightChangesWithTime) {
  const World world = wallAhead();
  RenderOptions options = test::smallCamera();
  options.light.cloud_share = 1.0;
  const Renderer renderer(options, 1);
  const auto left = [&](double time_s) {
    return renderer.images(renderer.sceneAt(world, Pose2{}, time_s), Pose2{}, 0.0, 0, 0).left;
  };
  double most = 0.0;
  for (double time_s = 20.0; time_s < 400.0; time_s += 20.0) {
    most = std::max(most, cv::norm(left(0.0), left(time_s), cv::NORM_L1) / (160 * 120));
  }
  EXPECT_GT(most, 4.0);  // grey levels
}

TEST(Renderer, AStrongSunSaturatesWalls) {
  const auto saturated = [](double sun) {
    RenderOptions options = test::smallCamera();
    options.light.sun = sun;
    options.light.cloud_share = 0.0;
    options.light.sun_azimuth_deg = 180.0;  // in the back of the robot, on the wall
    const Renderer renderer(options, 1);
    World world = wallAhead();
    int count = 0;
    for (world.seed = 1; world.seed <= 6; ++world.seed) {
      const Scene scene = renderer.sceneAt(world, Pose2{}, 0.0);
      count += cv::countNonZero(renderer.images(scene, Pose2{}, 0.0, 0, 0).left >= 255);
    }
    return count;
  };
  EXPECT_GT(saturated(3.0), saturated(1.0) + 1000);
}

TEST(Renderer, APolygonFromAUsersMapHasItsOwnWalls) {
  Building l_shaped;
  l_shaped.id = "L";
  l_shaped.shape = Polygon{{10, -8}, {20, -8}, {20, 8}, {16, 8}, {16, 0}, {10, 0}};
  Map map;
  map.buildings = {l_shaped};
  map.route = {{0, 0}, {2, 0}};
  const World world = worldFromMap(map, 1);
  const Renderer renderer(test::smallCamera(), 1);
  const Pose2 pose;
  const ImageTruth truth = renderer.truth(renderer.sceneAt(world, pose, 0.0), pose, 0.0);
  const ViewCamera camera = viewCamera(renderer.camera(), 160, 120, pose, 0.0);
  const auto depth_towards = [&](double y_over_x) {
    return truth.depth(50, static_cast<int>(std::lround(camera.cx - camera.fx * y_over_x)));
  };
  EXPECT_NEAR(depth_towards(-0.3), 10.0F, 0.01F);
  EXPECT_NEAR(depth_towards(0.3), 16.0F, 0.01F);
}

TEST(Renderer, RefusesWhatNoCameraCanBe) {
  const auto refuse = [](auto change, const char* place) {
    RenderOptions options;
    change(options);
    test::expectBadInput([&] { Renderer(options, 1); }, {place, "expected"});
  };
  refuse([](RenderOptions& o) { o.width = 63; }, "width");
  refuse([](RenderOptions& o) { o.height = 100000; }, "height");
  refuse([](RenderOptions& o) { o.horizontal_fov_deg = 180.0; }, "field of view");
  refuse([](RenderOptions& o) { o.baseline_m = 0.0; }, "baseline");
  refuse([](RenderOptions& o) { o.mount.z = std::nan(""); }, "camera height");
  refuse([](RenderOptions& o) { o.noise_sigma = -1.0; }, "noise");
  refuse([](RenderOptions& o) { o.light.sun_elevation_deg = 0.0; }, "elevation");
}

}  // namespace
}  // namespace handmap
