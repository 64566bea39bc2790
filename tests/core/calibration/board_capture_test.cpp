#include "core/calibration/board_capture.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/base/expect_error.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/calibration/rendered_boards.h"

namespace handmap {
namespace {

using test::boardAt;
using test::kBoard;

const StereoCalibration kCamera = test::boardCamera();

/// Both images of a board that is held before the cameras, as the person holds it for `looks`.
class Hand {
 public:
  explicit Hand(BoardCapture& capture) : capture_(capture) {}

  CaptureStatus hold(const test::BoardPose& pose, int looks = 3, double blur_px = 0.0) {
    cv::Mat left = test::leftImage(kCamera, pose);
    cv::Mat right = test::rightImage(kCamera, pose);
    if (blur_px > 0.0) {
      cv::GaussianBlur(left, left, {}, blur_px);
      cv::GaussianBlur(right, right, {}, blur_px);
    }
    return show(left, right, looks);
  }
  /// The status of the look that took it, else of the last one.
  CaptureStatus show(const cv::Mat& left, const cv::Mat& right, int looks = 3) {
    CaptureStatus status;
    for (int i = 0; i < looks; ++i) {
      time_s_ += 0.2;
      status = capture_.look(time_s_, left, right);
      if (status.verdict == BoardVerdict::Taken) break;
    }
    return status;
  }

 private:
  BoardCapture& capture_;
  double time_s_ = 0.0;
};

bool isMissing(const CaptureStatus& status, BoardNeed need) {
  return std::find(status.missing.begin(), status.missing.end(), need) != status.missing.end();
}

BoardPosture seenPosture(const test::BoardPose& pose) {
  return postureOf(findCorners(test::leftImage(kCamera, pose), kBoard), kBoard, kCamera.size);
}

TEST(BoardPosture, TellsWhichSideIsNearer) {
  EXPECT_NEAR(seenPosture(boardAt(244, 176, 0.8, {0, 0, 0})).turn, 0.0, 0.15);
  EXPECT_LT(seenPosture(boardAt(244, 176, 0.8, {0, 0.45, 0})).turn, -0.3) << "the right side";
  EXPECT_GT(seenPosture(boardAt(244, 176, 0.8, {0, -0.45, 0})).turn, 0.3);
  EXPECT_GT(seenPosture(boardAt(244, 176, 0.8, {0.45, 0, 0})).tilt, 0.3) << "the top";
  EXPECT_LT(seenPosture(boardAt(244, 176, 0.8, {-0.45, 0, 0})).tilt, -0.3);
  const BoardPosture rolled = seenPosture(boardAt(244, 176, 0.9, {0, 0, 0.4}));
  EXPECT_NEAR(rolled.roll, 0.4, 0.05);
  EXPECT_NEAR(rolled.extent, 0.32 * 430 / 0.9 / 480, 0.02);
  EXPECT_NEAR(rolled.centre.x, 244.0 / 480, 0.02);
}

TEST(BoardCorners, AGlimpseOfALargeImageIsWithinAPixelOrTwo) {
  cv::Mat large;
  cv::resize(test::leftImage(kCamera, boardAt(244, 176, 0.7, {0.2, 0.3, 0})), large, {}, 3, 3,
             cv::INTER_CUBIC);
  const auto exact = findCorners(large, kBoard);
  const auto glimpse = glimpseCorners(large, kBoard);
  ASSERT_EQ(exact.size(), 54U);
  ASSERT_EQ(glimpse.size(), 54U);
  for (std::size_t i = 0; i < exact.size(); ++i) EXPECT_LT(cv::norm(exact[i] - glimpse[i]), 2.0);
  EXPECT_TRUE(glimpseCorners(cv::Mat1b(300, 400, std::uint8_t(80)), kBoard).empty());
}

TEST(BoardCorners, ABoardIsNamedByItsInnerCorners) {
  EXPECT_EQ(parseBoardCorners("9x6"), cv::Size(9, 6));
  for (const char* wrong : {"9", "9x9", "2x6", "9x51", "9x", "9x6x3", "ax6", ""}) {
    EXPECT_TRUE(parseBoardCorners(wrong).empty()) << wrong;
  }
}

TEST(BoardCapture, TakesWhatIsStillSharpAndNew) {
  BoardCapture capture(kBoard, {});
  Hand hand(capture);
  const cv::Mat empty(360, 480, CV_8U, cv::Scalar(90));
  EXPECT_EQ(hand.show(empty, empty, 1).verdict, BoardVerdict::NotSeen);

  const auto pose = boardAt(260, 180, 0.8, {0, 0, 0});
  const cv::Mat left = test::leftImage(kCamera, pose);
  EXPECT_EQ(hand.show(left, empty, 1).verdict, BoardVerdict::InOneImage);
  EXPECT_EQ(hand.hold(pose, 1).verdict, BoardVerdict::Moving) << "it has just come";
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(hand.hold(boardAt(260 + 12 * i, 180, 0.8, {0, 0, 0}), 1).verdict,
              BoardVerdict::Moving);
  }
  EXPECT_EQ(hand.hold(boardAt(300, 180, 0.8, {0, 0, 0}), 4, 3.0).verdict, BoardVerdict::Blurred);
  const CaptureStatus taken = hand.hold(pose);
  EXPECT_EQ(taken.verdict, BoardVerdict::Taken);
  EXPECT_EQ(taken.taken, 1);
  EXPECT_EQ(taken.left_corners.size(), 54U);
  EXPECT_EQ(hand.hold(pose).verdict, BoardVerdict::Known);
  EXPECT_EQ(hand.hold(boardAt(270, 185, 0.82, {0.05, 0, 0})).verdict, BoardVerdict::Known);
  EXPECT_EQ(hand.hold(boardAt(260, 180, 0.8, {0, 0.4, 0})).verdict, BoardVerdict::Taken);
}

TEST(BoardCapture, SaysWhatIsMissingUntilItIsEnoughAndCalibrates) {
  const test::TemporaryFolder folder;
  BoardCapture capture(kBoard, folder.path());
  Hand hand(capture);
  CaptureStatus status;
  const auto poses = test::guidedPoses();
  for (std::size_t i = 0; i < kAllBoardNeeds.size(); ++i) {
    if (i > 0) {
      EXPECT_TRUE(isMissing(status, kAllBoardNeeds[i])) << i;
    }
    status = hand.hold(poses[i]);
    EXPECT_EQ(status.verdict, BoardVerdict::Taken) << i;
    EXPECT_FALSE(isMissing(status, kAllBoardNeeds[i])) << i;
  }
  EXPECT_TRUE(status.missing.empty());
  EXPECT_FALSE(status.enough) << "ten are few";
  for (std::size_t i = kAllBoardNeeds.size(); i < poses.size(); ++i) status = hand.hold(poses[i]);
  EXPECT_GE(status.taken, BoardSurvey::kEnough);
  EXPECT_TRUE(status.enough);

  const CapturedCalibration captured = capture.calibrate("cameras");
  EXPECT_NEAR(cv::norm(captured.result.calibration.translation), 0.12, 0.001);
  EXPECT_LT(captured.result.epipolar_error_px, 0.1);
  // Rows lie on rows.
  BoardView rectified{"", findCorners(captured.left, kBoard), findCorners(captured.right, kBoard)};
  ASSERT_EQ(rectified.left.size(), 54U);
  ASSERT_EQ(rectified.right.size(), 54U);
  alignOrder(rectified);
  for (std::size_t i = 0; i < rectified.left.size(); ++i) {
    EXPECT_NEAR(rectified.left[i].y, rectified.right[i].y, 0.5);
  }

  // What was kept gives the same calibration from its files.
  const CalibrationResult again = calibrateStereo(
      findBoards(folder.path() / "left", folder.path() / "right", kBoard), kBoard, "kept");
  EXPECT_EQ(formatStereoCalibration(again.calibration),
            formatStereoCalibration(captured.result.calibration));
}

TEST(BoardCapture, RefusesWhatCannotBe) {
  BoardCapture capture(kBoard, {});
  test::expectBadInput([&] { capture.calibrate("cameras"); }, {"cameras: found 0 pairs"});
  const cv::Mat image(360, 480, CV_8U, cv::Scalar(90));
  capture.look(0.0, image, image);
  const cv::Mat other(240, 320, CV_8U, cv::Scalar(90));
  test::expectBadInput([&] { capture.look(0.1, other, other); },
                       {"cameras: found an image of 320 × 240", "480 × 360 as the images before"});
}

}  // namespace
}  // namespace handmap
