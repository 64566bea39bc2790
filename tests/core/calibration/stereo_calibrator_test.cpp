#include "core/calibration/stereo_calibrator.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/recording/rectifier.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/calibration/rendered_boards.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::kBoard;

/// The corners as they would be found, without rendering them.
BoardImages projectedBoards(const StereoCalibration& camera,
                            const std::vector<test::BoardPose>& poses) {
  std::vector<cv::Point3f> corners;
  for (int row = 0; row < kBoard.corners.height; ++row) {
    for (int column = 0; column < kBoard.corners.width; ++column) {
      corners.emplace_back(static_cast<float>(column * kBoard.square_m),
                           static_cast<float>(row * kBoard.square_m), 0.0F);
    }
  }
  BoardImages images;
  images.size = camera.size;
  cv::RNG noise(1);
  for (const test::BoardPose& pose : poses) {
    BoardView view;
    view.name = std::to_string(images.views.size());
    cv::Matx33d turn;
    cv::Rodrigues(pose.turn, turn);
    cv::Vec3d right_turn;
    cv::Rodrigues(camera.rotation * turn, right_turn);
    cv::projectPoints(corners, pose.turn, pose.place, camera.left.matrix, camera.left.distortion,
                      view.left);
    cv::projectPoints(corners, right_turn, camera.rotation * pose.place + camera.translation,
                      camera.right.matrix, camera.right.distortion, view.right);
    for (auto* side : {&view.left, &view.right}) {
      for (cv::Point2f& corner : *side) {
        corner.x += static_cast<float>(noise.gaussian(0.1));
        corner.y += static_cast<float>(noise.gaussian(0.1));
      }
    }
    images.views.push_back(view);
  }
  return images;
}

class StereoCalibrator : public testing::Test {
 protected:
  std::string left() const { return (folder_.path() / "left").string(); }
  std::string right() const { return (folder_.path() / "right").string(); }

  test::TemporaryFolder folder_;
  const StereoCalibration truth_ = test::boardCamera();
};

TEST_F(StereoCalibrator, RecoversACameraFromImages) {
  test::writeBoards(folder_.path(), truth_, test::variedPoses());
  writePng(cv::Mat1b(360, 480, std::uint8_t(80)), folder_.path() / "right/03.png");
  folder_.write("left/04.png", "no image");
  std::filesystem::remove(folder_.path() / "left/05.png");
  folder_.write("left/notes.txt", "not an image, not meant to be one");
  int told = 0;
  const auto tell = [&](int done, int all) {
    EXPECT_EQ(done, told++);
    EXPECT_EQ(all, 11);
    return true;
  };
  const CalibrationResult result =
      calibrateStereo(findBoards(left(), right(), kBoard, tell), kBoard, "boards");
  EXPECT_EQ(told, 11);
  EXPECT_EQ(result.used.size(), 9u);
  ASSERT_EQ(result.refused.size(), 3u);
  EXPECT_EQ(result.refused[0].reason, "no whole board of 9 × 6 corners in the right image");
  EXPECT_NE(result.refused[1].reason.find("left/04.png: found no image"), std::string::npos);
  EXPECT_EQ(result.refused[2].reason, "no image of that name in the left folder");

  const StereoCalibration& found = result.calibration;
  EXPECT_NEAR(cv::norm(found.translation), cv::norm(truth_.translation), 0.0003);
  EXPECT_NEAR(found.left.matrix(0, 0), truth_.left.matrix(0, 0), 1.0);
  EXPECT_NEAR(found.left.matrix(1, 1), truth_.left.matrix(1, 1), 1.0);
  EXPECT_NEAR(found.right.matrix(0, 0), truth_.right.matrix(0, 0), 1.0);
  EXPECT_NEAR(found.left.matrix(0, 2), truth_.left.matrix(0, 2), 1.0);
  EXPECT_NEAR(found.left.distortion[0], truth_.left.distortion[0], 0.005);
  EXPECT_LT(cv::norm(found.rotation - truth_.rotation), 0.003);
  EXPECT_LT(result.left_error_px, 0.06);
  EXPECT_LT(result.right_error_px, 0.06);
  EXPECT_LT(result.epipolar_error_px, 0.06);
  EXPECT_GT(result.focal_sigma, 0.0);

  // It is what recordings take, and their points come out where they are.
  const auto path = folder_.write("calib.yml", formatStereoCalibration(found));
  const StereoCamera camera =
      Rectifier(readStereoCalibration(path), "calib.yml").camera(CameraMount());
  EXPECT_NEAR(camera.baseline, 0.12, 0.001);
}

TEST_F(StereoCalibrator, TellsTheErrorsInItsReport) {
  const CalibrationResult result =
      calibrateStereo(projectedBoards(truth_, test::variedPoses()), kBoard, "boards");
  const auto report = nlohmann::json::parse(calibrationReportJson(result, kBoard));
  EXPECT_EQ(report["board"]["columns"], 9);
  EXPECT_EQ(report["size_px"], (std::vector<int>{480, 360}));
  EXPECT_NEAR(report["baseline_m"], 0.12, 0.001);
  EXPECT_NEAR(report["left"]["focal_px"][0], 430, 3);
  // 0.1 px of noise in columns and in rows.
  EXPECT_NEAR(report["left"]["error_px"], 0.1 * std::sqrt(2.0), 0.02);
  EXPECT_NEAR(report["right"]["error_px"], 0.1 * std::sqrt(2.0), 0.02);
  // The mean difference of two such rows is 2/√π of their sigma.
  EXPECT_NEAR(report["epipolar_error_px"], 0.113, 0.02);
  EXPECT_NEAR(report["board_turn_deg"], 50, 5);
  EXPECT_EQ(report["used"].size(), 12u);
  EXPECT_EQ(report["used"][0]["name"], "0");
  EXPECT_EQ(report["refused"].size(), 0u);
}

TEST_F(StereoCalibrator, LeavesOutAPairThatDoesNotFit) {
  BoardImages images = projectedBoards(truth_, test::variedPoses());
  for (cv::Point2f& corner : images.views[4].right) corner.y += 12.0F;  // taken a moment later
  const CalibrationResult result = calibrateStereo(std::move(images), kBoard, "boards");
  ASSERT_EQ(result.refused.size(), 1u);
  EXPECT_EQ(result.refused[0].name, "4");
  EXPECT_NE(result.refused[0].reason.find("the others by"), std::string::npos);
  EXPECT_EQ(result.used.size(), 11u);
  EXPECT_NEAR(cv::norm(result.calibration.translation), 0.12, 0.001);
}

TEST_F(StereoCalibrator, RefusesNonsense) {
  const auto refuse = [](const BoardImages& images, const std::vector<std::string>& words) {
    expectBadInput([&] { calibrateStereo(images, kBoard, "boards"); }, words);
  };
  const BoardImages good = projectedBoards(truth_, test::variedPoses());
  BoardImages few = good;
  few.views.resize(5);
  few.refused = {{"07", "too dark"}};
  refuse(few, {"boards: found 5 pairs", "at least 6", "07: too dark"});

  BoardImages swapped = good;
  for (BoardView& view : swapped.views) std::swap(view.left, view.right);
  refuse(swapped, {"boards: T", "left and right look swapped"});

  std::vector<test::BoardPose> flat = test::variedPoses();
  for (test::BoardPose& pose : flat) pose.turn = {0.02, -0.01, 0.3 * pose.turn[0]};
  refuse(projectedBoards(truth_, flat), {"boards: ", "camera: found", "tilt the board"});

  BoardImages shaky = good;
  cv::RNG noise(2);
  for (BoardView& view : shaky.views) {
    for (cv::Point2f& corner : view.left) corner.x += static_cast<float>(noise.gaussian(1.2));
  }
  refuse(shaky, {"boards: found an error of the left camera of ", "at most 1 px"});

  BoardImages nothing = good;
  for (BoardView& view : nothing.views) {
    for (cv::Point2f& corner : view.left) corner = {100, 100};
  }
  refuse(nothing, {"boards: "});
}

TEST_F(StereoCalibrator, RefusesFoldersThatAreNone) {
  expectBadInput([&] { findBoards(left(), right(), kBoard); }, {"left", "no such folder"});
  folder_.write("left/a.txt", "");
  folder_.write("right/b.png", "");
  expectBadInput([&] { findBoards(left(), right(), kBoard); }, {"left", "no images"});
  folder_.write("left/a.png", "");
  expectBadInput([&] { findBoards(left(), right(), kBoard); }, {"left", "with one name"});
  writePng(cv::Mat1b(40, 60, std::uint8_t(0)), folder_.path() / "left/b.png");
  writePng(cv::Mat1b(40, 50, std::uint8_t(0)), folder_.path() / "right/b.png");
  expectBadInput([&] { findBoards(left(), right(), kBoard); },
                 {"right/b.png", "50 × 40", "60 × 40 as the images before"});
}

}  // namespace
}  // namespace handmap
