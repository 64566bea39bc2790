#include "core/recording/image_check.h"

#include <chrono>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::expectBadInput;

/// Spots of every size: what a camera may see.
cv::Mat picture(int width = 640, int height = 200) {
  cv::Mat fine = test::exampleImage(1, width, height);
  cv::Mat coarse = test::exampleImage(2, width / 8, height / 8);
  cv::resize(coarse, coarse, fine.size(), 0, 0, cv::INTER_CUBIC);
  cv::GaussianBlur(fine, fine, {}, 1.5);
  return 0.5 * fine + 0.5 * coarse;
}

cv::Mat shifted(const cv::Mat& image, int columns) {
  cv::Mat result;
  cv::warpAffine(image, result, cv::Matx23d(1, 0, columns, 0, 1, 0), image.size(),
                 cv::INTER_NEAREST, cv::BORDER_REFLECT);
  return result;
}

cv::Mat noisy(double grey, double sigma) {
  cv::Mat1b image(200, 640);
  cv::RNG random(7);
  random.fill(image, cv::RNG::NORMAL, grey, sigma);
  return image;
}

TEST(CheckPicture, TakesPictures) {
  checkPicture(picture(), "a.png");
  cv::Mat colour;
  cv::cvtColor(picture(), colour, cv::COLOR_GRAY2BGR);
  checkPicture(colour, "a.png");
  checkPicture(0.25 * picture(), "evening.png");
  cv::Mat sunny = picture();
  sunny.rowRange(0, 100) = 255;  // a white sky
  checkPicture(sunny, "sunny.png");
}

TEST(CheckPicture, RefusesCoveredAndOverexposed) {
  expectBadInput([] { checkPicture(noisy(3, 1), "a.png"); }, {"a.png", "% of the pixels black"});
  expectBadInput([] { checkPicture(noisy(90, 2), "a.png"); }, {"a.png: found no contrast"});
  expectBadInput([] { checkPicture(noisy(254, 3), "a.png"); }, {"saturated", "overexposed"});
  cv::Mat finger;  // light through it, brighter on one side
  cv::resize(cv::Mat(cv::Matx<std::uint8_t, 1, 2>(30, 140)), finger, {640, 200}, 0, 0,
             cv::INTER_LINEAR);
  expectBadInput([&] { checkPicture(finger, "a.png"); }, {"no contrast", "covered"});
  expectBadInput([] { checkPicture(cv::Mat1b(1, 1), "a.png"); }, {"hardly a pixel"});
}

TEST(CheckPicture, IsQuick) {
  const cv::Mat image = picture(1242, 375);
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) checkPicture(image, "a.png");
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  EXPECT_LT(spent.count() / 20, 1.0);
}

TEST(SwapCheck, TellsSwappedPairs) {
  const cv::Mat left = picture();
  const cv::Mat right = shifted(left, -9);  // what is near is farther left in the right image
  SwapCheck()(left, right, "right.png");
  SwapCheck()(left, left, "right.png");  // all far away
  SwapCheck()(left, noisy(90, 30), "right.png");
  SwapCheck check;
  for (int i = 0; i < 30; ++i) {  // again and again, until a pair is right
    expectBadInput([&] { check(right, left, "right.png"); },
                   {"right.png", "left and right look swapped"});
  }
  for (int i = 0; i < 3; ++i) check(left, right, "right.png");
  EXPECT_NO_THROW(check(right, left, "right.png"));  // no longer looked at
}

TEST(Replay, RefusesBadPairsAndGoesOn) {
  const test::ExampleRecording example;
  example.folder().write("frames.csv",
                         "frame,time_s,left,right,right_time_s\n"
                         "0,10,image_0/0.png,image_1/0.png,10.004\n"
                         "1,11,image_0/1.png,image_1/1.png,11.02\n"
                         "2,12,image_0/2.png,image_1/2.png,\n"
                         "3,13,image_0/3.png,image_1/3.png,12.98\n"
                         "4,14,image_0/4.png,image_1/4.png,14\n"
                         "5,15,image_0/5.png,image_1/5.png,15\n");
  writePng(cv::Mat1b(16, 32, std::uint8_t(0)), example.path() / "image_1/4.png");
  const auto source = replay(openRecording(example.path()), {});
  EXPECT_EQ(test::framesOf(*source), (std::vector<int>{0, -1, 2, -3, -4, 5}));
  const auto again = replay(openRecording(example.path()), {.from = 1});
  try {
    again->next();
    ADD_FAILURE() << "no error";
  } catch (const FrameError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("image_1/1.png: found the right image taken at 11.02 s, the left one at 11 "
                        "s, expected both within 0.01 s"),
              std::string::npos)
        << error.what();
  }
  example.folder().write("frames.csv",
                         "frame,time_s,left,right,right_time_s\n0,1,a.png,b.png,soon\n");
  expectBadInput([&] { openRecording(example.path()); }, {"line 2: right_time_s", "soon"});
}

TEST(Replay, RefusesImagesScaledAfterTheCalibration) {
  const test::ExampleRecording example;
  example.folder().write(
      "calib.txt", "P0: 700 0 31 0 0 710 16 0 0 0 1 0\nP1: 700 0 31 -350 0 710 16 0 0 0 1 0\n");
  const auto source = replay(openRecording(example.path()), {});
  try {
    source->next();
    ADD_FAILURE() << "no error";
  } catch (const FrameError& error) {
    EXPECT_NE(std::string(error.what()).find("images that the calibration belongs to"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace handmap
