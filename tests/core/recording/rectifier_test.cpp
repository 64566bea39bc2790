#include "core/recording/rectifier.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/recording/recording.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_calibration.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::exampleCalibration;
using test::expectBadInput;

/// A bright dot on black.
cv::Mat dotAt(const cv::Point2d& place, cv::Size size) {
  cv::Mat1b image(size, std::uint8_t(0));
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const double r = std::hypot(u - place.x, v - place.y);
      image(v, u) = cv::saturate_cast<std::uint8_t>(250.0 * std::exp(-r * r / 8.0));
    }
  }
  return image;
}

cv::Point2d centreOf(const cv::Mat& image) {
  const cv::Moments moments = cv::moments(image);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

TEST(Rectifier, MakesPointsAppearInOneRowAtTheirDistance) {
  const StereoCalibration calibration = exampleCalibration();
  const Rectifier rectifier(calibration, "calib.yml");
  const StereoCamera camera = rectifier.camera({0, 0, 1.2, 0, 0});
  EXPECT_NEAR(camera.baseline, cv::norm(calibration.translation), 1e-9);
  EXPECT_EQ(camera.mount.z, 1.2);
  double raw_error_px = 0.0;
  for (const cv::Point3d& point :
       {cv::Point3d(0, 0, 3), cv::Point3d(-0.9, 0.5, 3), cv::Point3d(1.2, -0.7, 3.5),
        cv::Point3d(2, 1.5, 8), cv::Point3d(-3, -1, 9)}) {
    const test::PixelPair seen = test::seenBy(calibration, point);
    const cv::Point2d left = centreOf(rectifier.left(dotAt(seen.left, calibration.size)));
    const cv::Point2d right = centreOf(rectifier.right(dotAt(seen.right, calibration.size)));
    raw_error_px = std::max(raw_error_px, std::abs(seen.left.y - seen.right.y));
    EXPECT_NEAR(left.y, right.y, 0.05);
    const double z = camera.fx * camera.baseline / (left.x - right.x);
    const double distance =
        z * std::hypot(1.0, (left.x - camera.cx) / camera.fx, (left.y - camera.cy) / camera.fy);
    EXPECT_NEAR(distance, cv::norm(point), 0.02 * cv::norm(point));
  }
  EXPECT_GT(raw_error_px, 5.0);
}

TEST(StereoCalibration, WrittenReadsBack) {
  const test::TemporaryFolder folder;
  const StereoCalibration written = exampleCalibration();
  const StereoCalibration read =
      readStereoCalibration(folder.write("calib.yml", formatStereoCalibration(written)));
  EXPECT_EQ(read.size, written.size);
  EXPECT_EQ(read.left.matrix, written.left.matrix);
  EXPECT_EQ(read.right.matrix, written.right.matrix);
  EXPECT_EQ(read.left.distortion, written.left.distortion);
  EXPECT_EQ(read.right.distortion, written.right.distortion);
  EXPECT_EQ(read.rotation, written.rotation);
  EXPECT_EQ(read.translation, written.translation);
}

TEST(StereoCalibration, ReadsOtherFormsOfTheFile) {
  const test::TemporaryFolder folder;
  const StereoCalibration example = exampleCalibration();
  const auto path = folder.path() / "calib.xml";
  {
    cv::FileStorage file(path.string(), cv::FileStorage::WRITE);
    file << "image_size" << example.size;
    file << "camera_matrix_left" << cv::Mat(example.left.matrix);
    file << "distortion_left" << cv::Mat(example.left.distortion).t();
    file << "camera_matrix_right" << cv::Mat(example.right.matrix);
    file << "distortion_right" << cv::Mat(example.right.distortion);
    file << "R" << cv::Mat(example.rotation) << "T" << cv::Mat(example.translation);
  }
  const StereoCalibration read = readStereoCalibration(path);
  EXPECT_EQ(read.size, example.size);
  EXPECT_EQ(read.left.matrix, example.left.matrix);
  EXPECT_EQ(read.right.distortion, example.right.distortion);
  EXPECT_EQ(read.translation, example.translation);
}

TEST(StereoCalibration, RefusesWhatIsNone) {
  const test::TemporaryFolder folder;
  const auto refuse = [&](const std::string& text, const std::vector<std::string>& words) {
    const auto path = folder.write("calib.yml", text);
    expectBadInput([&] { readStereoCalibration(path); }, words);
  };
  const std::string good = formatStereoCalibration(exampleCalibration());
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  };
  refuse("", {"calib.yml", "empty file"});
  refuse("%YAML:1.0\n---\nM1: [", {"calib.yml"});
  refuse("P0: 1 0 0", {"calib.yml"});
  refuse("%YAML:1.0\n---\n- 1\n",
         {"calib.yml: found no calibration of OpenCV, expected a YAML or XML file"});
  refuse("%YAML:1.0\n---\na: " + std::string(40000, '['), {"too many values"});
  refuse("<?xml version=\"1.0\"?>\n<opencv_storage>\n<M1><rows>3</rows><data", {"calib.yml"});
  refuse("<?xml version=\"1.0\"?>" + std::string(2000, '<'), {"too many values"});
  refuse(good.substr(0, good.find("R: ")), {"R: found nothing"});
  refuse(replaced("image_width: 640", "image_width: 1e9"), {"image_width", "1 to 32768"});
  refuse(replaced("image_width: 640\nimage_height: 480", "image_width: 9000\nimage_height: 9000"),
         {"image_width and image_height: found 9000 × 9000 pixels, expected at most 64 mega"});
  refuse(replaced("image_width: 640\n", ""), {"image_width: found nothing"});
  refuse(replaced("M1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 5",
                  "M1: !!opencv-matrix\n   rows: 3000000\n   cols: 3000000\n   dt: d\n   data: [ "
                  "-5"),
         {"M1: found a focal length of -520"});
  refuse(replaced("5.2", ".Nan, 5.2"), {"M1: found 10 numbers"});
}

TEST(StereoCalibration, RefusesCamerasThatCannotBe) {
  const auto refuse = [](auto spoil, const std::vector<std::string>& words) {
    StereoCalibration bad = exampleCalibration();
    spoil(bad);
    expectBadInput([&] { checkStereoCalibration(bad, "calib.yml"); }, words);
  };
  using Calibration = StereoCalibration;
  refuse([](Calibration& c) { c.left.matrix(0, 0) = 3; }, {"M1", "focal length of 3 px"});
  refuse([](Calibration& c) { c.right.matrix(0, 2) = 900; }, {"M2", "principal point at 900"});
  refuse([](Calibration& c) { c.right.matrix(2, 2) = 2; }, {"M2", "no camera matrix"});
  refuse([](Calibration& c) { c.rotation(0, 0) = 1.2; }, {"R", "no rotation matrix"});
  refuse([](Calibration& c) { c.rotation = cv::Matx33d::diag({-1, -1, 1}); }, {"R", "180°"});
  refuse([](Calibration& c) { c.translation *= 1000; }, {"T", "metres"});
  refuse([](Calibration& c) { c.translation *= 0; }, {"T", "0.005"});
  refuse([](Calibration& c) { c.translation *= -1; }, {"T", "look swapped"});
  refuse([](Calibration& c) { c.translation = {0.01, 0.3, 0}; }, {"T", "side by side"});
  StereoCalibration bent = exampleCalibration();
  bent.left.distortion = {-3, 5, 0, 0, 0};
  expectBadInput([&] { Rectifier(bent, "calib.yml"); }, {"calib.yml", "scaled by"});
}

TEST(Recording, RectifiesWhatIsNotRectified) {
  const test::ExampleRecording example;
  example.folder().write("recording.json", R"({"format": "handmap-recording", "version": 1,
      "camera": {"calibration": "stereo.yml", "rectified": false, "mount": {"z_m": 1.1}}})");
  StereoCalibration calibration = exampleCalibration();
  example.folder().write("stereo.yml", formatStereoCalibration(calibration));
  const auto first = [&] { return replay(openRecording(example.path()), {})->next(); };
  try {
    first();
    ADD_FAILURE() << "images of another size were taken";
  } catch (const FrameError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("found 32 × 16 pixels, expected 640 × 480 as the calibration says"),
              std::string::npos)
        << text;
  }
  const cv::Mat raw = test::exampleImage(5, 640, 480);
  writePng(raw, example.path() / "image_0/0.png");
  const cv::Mat raw_right = test::exampleImage(6, 640, 480);
  writePng(raw_right, example.path() / "image_1/0.png");
  const auto observation = first();
  ASSERT_TRUE(observation);
  const Rectifier rectifier(calibration, "");
  EXPECT_TRUE(test::sameImage(observation->views[0].left, rectifier.left(raw)));
  EXPECT_TRUE(test::sameImage(observation->views[0].right, rectifier.right(raw_right)));
  EXPECT_FALSE(test::sameImage(observation->views[0].left, raw));
  const Recording recording = openRecording(example.path());
  EXPECT_EQ(recording.camera->fx, rectifier.camera({}).fx);
  EXPECT_EQ(recording.camera->mount.z, 1.1);
}

}  // namespace
}  // namespace handmap
