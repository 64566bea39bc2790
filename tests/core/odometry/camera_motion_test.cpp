#include "core/odometry/camera_motion.h"

#include <gtest/gtest.h>

#include "core/geometry/pose2.h"

namespace handmap {
namespace {

const StereoCamera kCamera{700, 705, 320, 120, 0.5, {}};

Eigen::Isometry3d motionOf(const Eigen::Vector3d& turn, const Eigen::Vector3d& shift) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  motion.translation() = shift;
  return motion;
}

const Eigen::Isometry3d kDriving = motionOf({0.004, -0.03, 0.002}, {0.02, 0.01, -1.1});

/// Points 5 to 35 m ahead that move by `motion`, seen with an error of `sigma_px`.
std::vector<StereoMatch> pointsMoving(const Eigen::Isometry3d& motion, int count, double sigma_px,
                                      std::uint32_t stream = 0) {
  RandomStream random(3, stream);
  const auto noise = [&] { return random.normal(0.0, sigma_px); };
  std::vector<StereoMatch> matches;
  for (int i = 0; i < count; ++i) {
    const double z = random.uniform(5.0, 35.0);
    const Eigen::Vector3d point(z * random.uniform(-0.6, 0.6), z * random.uniform(-0.2, 0.2), z);
    StereoMatch match{projected(kCamera, point), projected(kCamera, motion * point)};
    match.before += StereoPixel(noise(), noise(), noise());
    match.now += StereoPixel(noise(), noise(), noise());
    matches.push_back(match);
  }
  return matches;
}

void append(std::vector<StereoMatch>& matches, const std::vector<StereoMatch>& more) {
  matches.insert(matches.end(), more.begin(), more.end());
}

std::vector<StereoMatch> nonsense(int count) {
  RandomStream random(5);
  const auto pixel = [&] {
    const double u = random.uniform(0.0, 640.0);
    return StereoPixel(u, random.uniform(0.0, 240.0), u - random.uniform(2.0, 60.0));
  };
  std::vector<StereoMatch> matches;
  for (int i = 0; i < count; ++i) matches.push_back({pixel(), pixel()});
  return matches;
}

void expectNear(const Eigen::Isometry3d& found, const Eigen::Isometry3d& truth, double metres,
                double radians) {
  EXPECT_LT((found.translation() - truth.translation()).norm(), metres);
  EXPECT_LT(Eigen::AngleAxisd(found.linear().transpose() * truth.linear()).angle(), radians);
}

TEST(CameraMotion, ProjectionIsTheInverseOfTriangulation) {
  const Eigen::Vector3d point(-2.0, 0.7, 9.0);
  const StereoPixel pixel = projected(kCamera, point);
  EXPECT_NEAR(pixel.x() - pixel.z(), 700 * 0.5 / 9.0, 1e-9);
  EXPECT_LT((triangulated(kCamera, pixel) - point).norm(), 1e-9);
}

TEST(CameraMotion, IsExactWithoutNoise) {
  const auto found = estimateMotion(kCamera, pointsMoving(kDriving, 30, 0.0),
                                    Eigen::Isometry3d::Identity(), RandomStream(1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->inliers.size(), 30u);
  expectNear(found->motion, kDriving, 1e-6, 1e-7);
}

TEST(CameraMotion, HoldsAgainstNoiseNonsenseAndAnotherCar) {
  std::vector<StereoMatch> matches = pointsMoving(kDriving, 150, 0.3);
  append(matches, pointsMoving(motionOf({0, 0.02, 0}, {0.5, 0, 0.4}), 70, 0.3, 1));
  append(matches, nonsense(80));
  const auto found =
      estimateMotion(kCamera, matches, Eigen::Isometry3d::Identity(), RandomStream(1));
  ASSERT_TRUE(found);
  expectNear(found->motion, kDriving, 0.03, 0.002);
  EXPECT_GT(found->inliers.size(), 120u);
  EXPECT_LT(found->inliers.size(), 165u);
  // The same stream, the same bytes.
  const auto again =
      estimateMotion(kCamera, matches, Eigen::Isometry3d::Identity(), RandomStream(1));
  EXPECT_EQ(again->motion.matrix(), found->motion.matrix());
}

TEST(CameraMotion, HasNoBiasFromFarPoints) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const auto found =
        estimateMotion(kCamera, pointsMoving(kDriving, 100, 0.3, i), kDriving, RandomStream(1, i));
    ASSERT_TRUE(found);
    sum += found->motion.translation().z();
  }
  EXPECT_NEAR(sum / 40, kDriving.translation().z(), 0.003);
}

TEST(CameraMotion, IsNotMadeUp) {
  const auto from = Eigen::Isometry3d::Identity();
  EXPECT_FALSE(estimateMotion(kCamera, {}, from, RandomStream(1)));
  EXPECT_FALSE(estimateMotion(kCamera, pointsMoving(kDriving, 14, 0.1), from, RandomStream(1)));
  EXPECT_FALSE(estimateMotion(kCamera, nonsense(300), from, RandomStream(1)));
}

}  // namespace
}  // namespace handmap
