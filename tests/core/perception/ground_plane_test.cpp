#include "core/perception/ground_plane.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/core/perception/rendered_scene.h"

namespace handmap {
namespace {

const cv::Size kSize(621, 188);

/// What a camera sees of a plane, with noise; `clutter` is the share of pixels that see a thing up
/// to 1 m high instead.
cv::Mat1f disparityOf(const GroundPlane& plane, const StereoCamera& camera, const CameraRays& rays,
                      double clutter) {
  RandomStream random(1);
  cv::Mat1f disparity(kSize, -1.0F);
  for (int row = 0; row < kSize.height; ++row) {
    for (int column = 0; column < kSize.width; ++column) {
      const auto r = static_cast<std::size_t>(row);
      const auto c = static_cast<std::size_t>(column);
      const double lift = random.uniform() < clutter ? random.uniform(0.2, 1.0) : 0.0;
      const double sinking =
          plane.slope_x * rays.forward[r] + plane.slope_y * rays.left[c] - rays.up[r];
      if (sinking <= 0.01) continue;
      const double depth = (camera.mount.z - plane.height - lift) / sinking;
      disparity(row, column) =
          static_cast<float>(camera.fx * camera.baseline / depth + random.normal(0.0, 0.2));
    }
  }
  return disparity;
}

TEST(GroundPlane, FindsHeightAndSlopesAmongClutter) {
  const StereoCamera camera = reducedCamera(test::streetCamera(), 2.0, 2.0);
  const CameraRays rays(camera, kSize);
  const GroundPlane truth{0.06, 0.03, -0.02};
  const GroundPlane found = fitGround(disparityOf(truth, camera, rays, 0.3), camera, rays);
  EXPECT_NEAR(found.height, truth.height, 0.02);
  EXPECT_NEAR(found.slope_x, truth.slope_x, 0.003);
  EXPECT_NEAR(found.slope_y, truth.slope_y, 0.003);
}

TEST(GroundPlane, TrustsTheMountWhereNoGroundIsSeen) {
  const StereoCamera camera = reducedCamera(test::streetCamera(), 2.0, 2.0);
  const GroundPlane found = fitGround(cv::Mat1f(kSize, -1.0F), camera, CameraRays(camera, kSize));
  EXPECT_EQ(found.height, 0.0);
  EXPECT_EQ(found.slope_x, 0.0);
  EXPECT_EQ(found.slope_y, 0.0);
}

TEST(CameraRays, ReducingKeepsTheDirections) {
  const StereoCamera camera = test::streetCamera();
  const CameraRays whole(camera, {1242, 376});
  const CameraRays half(reducedCamera(camera, 2.0, 2.0), {621, 188});
  EXPECT_NEAR(half.left[100], 0.5 * (whole.left[200] + whole.left[201]), 1e-12);
  EXPECT_NEAR(half.up[50], 0.5 * (whole.up[100] + whole.up[101]), 1e-12);
}

}  // namespace
}  // namespace handmap
