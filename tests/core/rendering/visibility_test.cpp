#include "core/rendering/visibility.h"

#include <gtest/gtest.h>

#include "tests/core/rendering/views.h"

namespace handmap {
namespace {

/// Pitched, turned, off the origin.
ViewCamera obliqueCamera() {
  RenderOptions options = test::smallCamera();
  options.mount = {0.3, -0.2, 1.4, 0.1, 0.2};
  return viewCamera(cameraOf(options), options.width, options.height, {2.0, 1.0, 0.5}, -0.3);
}

Surface wall(const Vec3& a, const Vec3& b, double top) {
  return surfaceOf({a, b, {b.x(), b.y(), top}, {a.x(), a.y(), top}}, Material::Plain,
                   Label::Building, Colour::Zero(), 1);
}

TEST(Visibility, DepthIsThatOfTheRay) {
  const ViewCamera camera = obliqueCamera();
  const Vec3 centre = camera.eye + 8.0 * camera.forward;
  const Vec3 aside = Vec3(camera.right.x(), camera.right.y(), 0.3).normalized();
  const Vec3 up(0.2, -0.1, 1.0);
  const Surface face = surfaceOf({centre - 2 * aside - up, centre + 2 * aside - up,
                                  centre + 2 * aside + up, centre - 2 * aside + up},
                                 Material::Plain, Label::Building, Colour::Zero(), 1);
  const Visibility seen = visibilityOf({face}, camera, 1);
  int on_face = 0;
  for (int row = 0; row < camera.height; ++row) {
    for (int column = 0; column < camera.width; ++column) {
      const Vec3 ray = camera.ray(column, row);
      const std::size_t i = seen.index(column, row);
      const double to_plane = face.normal.dot(centre - camera.eye) / face.normal.dot(ray);
      const Vec3 from_centre = camera.eye + to_plane * ray - centre;
      // In the parallelogram's own coordinates.
      const Vec3 v_axis = up - up.dot(aside) * aside;
      const double v = from_centre.dot(v_axis) / v_axis.squaredNorm();
      const double u = (from_centre - v * up).dot(aside);
      const double margin = 1.0 - std::max(std::abs(u) / 2.0, std::abs(v));
      if (std::abs(margin) < 1e-6) continue;
      const double to_ground = ray.z() < 0.0 ? -camera.eye.z() / ray.z() : 1e9;
      if (margin > 0.0 && to_plane < to_ground) {
        ++on_face;
        ASSERT_EQ(seen.seen[i], 0) << column << ", " << row;
        ASSERT_NEAR(1.0 / static_cast<double>(seen.inverse_depth[i]), to_plane, 1e-5 * to_plane);
      } else if (to_ground < 2000.0) {
        ASSERT_EQ(seen.seen[i], Visibility::kGround);
        ASSERT_NEAR(1.0 / static_cast<double>(seen.inverse_depth[i]), to_ground, 1e-4 * to_ground);
      } else {
        ASSERT_EQ(seen.seen[i], Visibility::kSky);
        ASSERT_EQ(seen.inverse_depth[i], 0.0F);
      }
    }
  }
  EXPECT_GT(on_face, 1000);
}

TEST(Visibility, TheNearerSurfaceHidesTheOther) {
  const ViewCamera camera = viewCamera(cameraOf(test::smallCamera()), 160, 120, Pose2{}, 0.0);
  const std::vector<Surface> walls{wall({20, 5, 0}, {20, -5, 0}, 3.0),
                                   wall({10, 1, 0}, {10, -1, 0}, 3.0)};
  for (const bool turned : {false, true}) {
    std::vector<Surface> order = walls;
    if (turned) std::swap(order[0], order[1]);
    const Visibility seen = visibilityOf(order, camera, 1);
    const std::size_t middle = seen.index(80, 60);
    EXPECT_EQ(seen.seen[middle], turned ? 0 : 1);
    EXPECT_NEAR(seen.inverse_depth[middle], 0.1F, 1e-6F);
  }
}

TEST(Visibility, WhatReachesBehindTheCameraIsCutOff) {
  const ViewCamera camera = viewCamera(cameraOf(test::smallCamera()), 160, 120, Pose2{}, 0.0);
  const Visibility seen = visibilityOf({wall({-30, 4, 0}, {30, 4, 0}, 50.0)}, camera, 1);
  for (int row = 1; row < 119; ++row) {
    const Vec3 ray = camera.ray(0.0, row);
    const double depth = 4.0 / ray.y();
    const double height = 1.5 + depth * ray.z();
    if (height < 0.1) continue;
    ASSERT_EQ(seen.seen[seen.index(0, row)], 0);
    ASSERT_NEAR(1.0 / static_cast<double>(seen.inverse_depth[seen.index(0, row)]), depth, 1e-4);
  }
}

}  // namespace
}  // namespace handmap
