#include "core/bags/ros_camera.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"

namespace handmap::ros {
namespace {

CameraInfo infoOf(double baseline_m) {
  CameraInfo info;
  info.size = {64, 48};
  info.model = "plumb_bob";
  info.distortion = {-0.2, 0.05, 0, 0, 0};
  info.matrix = cv::Matx33d(50, 0, 32, 0, 50, 24, 0, 0, 1);
  info.rectification = cv::Matx33d::eye();
  info.projection = cv::Matx34d(50, 0, 32, -50 * baseline_m, 0, 50, 24, 0, 0, 0, 1, 0);
  return info;
}

TEST(RosCamera, ALensIsRectifiedUnlessTheImagesAre) {
  cv::Mat image(48, 64, CV_8UC1);
  cv::randu(image, 0, 255);
  const auto differs = [&](bool rectified) {
    const Rectifier rectifier = rectifierOf(infoOf(0.0), infoOf(0.1), rectified, "robot");
    EXPECT_NEAR(rectifier.camera({}).baseline, 0.1, 1e-12);
    return cv::norm(rectifier.left(image), image, cv::NORM_INF) > 0.0;
  };
  EXPECT_TRUE(differs(false));
  EXPECT_FALSE(differs(true));
}

TEST(RosCamera, WhatIsNoPairIsRefused) {
  const auto refused = [](const CameraInfo& left, const CameraInfo& right) {
    EXPECT_THROW(rectifierOf(left, right, false, "robot"), Error);
  };
  refused(infoOf(0.0), infoOf(0.0));
  refused(infoOf(0.0), infoOf(-0.1));
  refused(CameraInfo{}, CameraInfo{});
  CameraInfo other = infoOf(0.1);
  other.size = {32, 24};
  refused(infoOf(0.0), other);
  other = infoOf(0.1);
  other.projection(1, 2) = 25.0;
  refused(infoOf(0.0), other);
  CameraInfo left = infoOf(0.0);
  other = infoOf(0.1);
  left.size = other.size = {100'000, 100'000};  // nothing is allocated on its word
  refused(left, other);
}

TEST(RosCamera, WhereItIsToldAndWhetherImagesAreRectified) {
  EXPECT_EQ(cameraInfoTopic("/left/image_raw/compressed"), "/left/camera_info");
  EXPECT_EQ(cameraInfoTopic("/left/image_raw"), "/left/camera_info");
  EXPECT_EQ(cameraInfoTopic("image"), "camera_info");
  EXPECT_TRUE(namesRectified("/left/image_rect_color/compressed"));
  EXPECT_TRUE(namesRectified("/left/rectified"));
  EXPECT_FALSE(namesRectified("/direct/left/image_raw"));
}

}  // namespace
}  // namespace handmap::ros
