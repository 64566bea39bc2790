#include "core/kitti_raw/kitti_raw.h"

#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/recording/image_file.h"
#include "core/recording/recording.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

namespace fs = std::filesystem;

/// A drive of three moments, 1 m each to the north, of which the second has no scan.
class KittiRaw : public testing::Test {
 protected:
  KittiRaw() {
    write(day() / "calib_cam_to_cam.txt",
          "calib_time: 09-Jan-2012 13:57:47\nR_rect_00: 1 0 0 0 1 0 0 0 1\n"
          "P_rect_00: 700 0 64 0 0 700 48 0 0 0 1 0\n"
          "P_rect_01: 700 0 64 -350 0 700 48 0 0 0 1 0\n");
    // x ahead, y left, z up, 0.25 m behind the camera and 0.05 m above it
    write(day() / "calib_velo_to_cam.txt", "R: 0 -1 0 0 0 -1 1 0 0\nT: 0 -0.05 -0.25\n");
    write(day() / "calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: -0.75 0 0\n");
    std::string times;
    for (int i = 0; i < 3; ++i) {
      times += fmt::format("2011-09-26 13:02:25.{}00000000\n", i + 5);
      for (const char* camera : {"image_00", "image_01"}) {
        writeImage(drive() / camera / "data" / fmt::format("{:010}.png", i));
      }
      const double north_deg = i / (6378137.0 * M_PI / 180.0);
      write(drive() / "oxts/data" / fmt::format("{:010}.txt", i),
            fmt::format("{:.12f} 8.4 116 0 0 {} 1 2 3\n", 49.0 + north_deg, M_PI / 2));
      const float point[4] = {10.0F, 1.0F, 0.3F, 0.9F};
      if (i == 1) continue;
      write(drive() / "velodyne_points/data" / fmt::format("{:010}.bin", i),
            std::string(reinterpret_cast<const char*>(point), sizeof(point)));
    }
    for (const char* sensor : {"image_00", "image_01", "velodyne_points", "oxts"}) {
      write(drive() / sensor / "timestamps.txt", times);
    }
  }
  fs::path day() const { return folder_.path() / "2011_09_26"; }
  fs::path drive() const { return day() / "2011_09_26_drive_0005_sync"; }
  fs::path out() const { return folder_.path() / "recording"; }
  static void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  static void writeImage(const fs::path& path) {
    fs::create_directories(path.parent_path());
    cv::Mat image(96, 128, CV_8UC1);
    cv::randu(image, 0, 255);
    writePng(image, path);
  }
  ImportedDrive import() { return importKittiRaw(drive(), out(), "drive", notes_); }
  /// What is said of it as it is now.
  std::string refusal() {
    try {
      import();
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(KittiRaw, ADriveIsARecording) {
  EXPECT_TRUE(isKittiRaw(drive()));
  EXPECT_FALSE(isKittiRaw(day()));
  const ImportedDrive imported = import();
  EXPECT_EQ(imported.pairs, 3U);
  EXPECT_EQ(imported.scans, 2U);
  EXPECT_EQ(imported.poses, 3U);
  const Recording recording = openRecording(out());
  ASSERT_EQ(recording.rows.size(), 3U);
  EXPECT_NEAR(recording.rows[1].time_s - recording.rows[0].time_s, 0.1, 1e-6);
  EXPECT_NEAR(recording.rows[0].time_s, 1317042145.5, 1e-6);
  EXPECT_TRUE(recording.rows[1].points.empty());
  ReplayOptions images;
  images.visual_odometry = true;
  const auto source = replay(recording, images);
  ASSERT_TRUE(source->info().camera);
  EXPECT_NEAR(source->info().camera->baseline, 0.5, 1e-9);
  EXPECT_EQ(source->next()->views.front().left.cols, 128);
  ReplayOptions scans;
  scans.kind = SourceKind::Points;
  scans.without_odometry = true;
  const auto first = replay(recording, scans)->next();
  ASSERT_TRUE(first);
  const auto& points = first->views.front().points;
  ASSERT_TRUE(points && points->size() == 1U);
  EXPECT_NEAR(points->front().x, 9.75F, 1e-5F);
  EXPECT_NEAR(points->front().y, 1.0F, 1e-5F);
  EXPECT_NEAR(points->front().z, 2.0F, 1e-5F);
}

/// Of the camera, which is 1 m ahead of the inertial unit.
TEST_F(KittiRaw, TheTrueWayIsInMetres) {
  import();
  const auto truth = readTum(out() / "truth.tum").poses();
  ASSERT_EQ(truth.size(), 3U);
  EXPECT_NEAR(truth[0].pose.y, 1.0, 1e-3);
  EXPECT_NEAR(truth[2].pose.y - truth[0].pose.y, 2.0, 0.01);
  EXPECT_NEAR(truth[2].pose.x, 0.0, 1e-3);
  EXPECT_NEAR(truth[2].pose.heading, M_PI / 2, 1e-6);
}

TEST_F(KittiRaw, WhatIsDamagedIsNamed) {
  write(drive() / "image_00/timestamps.txt", "2011-09-26 13:02:25.5\n2011-13-26 13:02:26\n");
  EXPECT_NE(refusal().find("timestamps.txt: line 2: found \"2011-13-26"), std::string::npos);
}

TEST_F(KittiRaw, TimesDoNotGoBack) {
  write(drive() / "image_00/timestamps.txt", "2011-09-26 13:02:25.5\n2011-09-26 13:02:25.4\n");
  EXPECT_NE(refusal().find("line 2"), std::string::npos);
}

TEST_F(KittiRaw, ACutOffScanIsNamed) {
  write(drive() / "velodyne_points/data/0000000002.bin", "123");
  EXPECT_NE(refusal().find("0000000002.bin: found 3 bytes"), std::string::npos);
}

TEST_F(KittiRaw, ItIsSaidWhichCalibrationIsMissing) {
  fs::remove(day() / "calib_cam_to_cam.txt");
  EXPECT_NE(refusal().find("calib_cam_to_cam.txt"), std::string::npos);
}

TEST_F(KittiRaw, ADriveThatIsNotRectifiedIsRefused) {
  EXPECT_THROW(importKittiRaw("somewhere_extract", out(), "drive", notes_), Error);
}

}  // namespace
}  // namespace handmap
