// The single files of a recording: calibration, table of frames, points, images.
#include <limits>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/random.h"
#include "core/recording/calibration.h"
#include "core/recording/frame_table.h"
#include "tests/core/base/comma_locale.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/recording/example_recording.h"

namespace handmap {
namespace {

using test::expectBadInput;
using test::TemporaryFolder;

const std::string kLeft = "P0: 700 0 600 0 0 710 180 0 0 0 1 0\n";

class Files : public ::testing::Test {
 protected:
  void refuseCalibration(const std::string& content, const std::vector<std::string>& words) {
    const auto path = folder_.write("calib.txt", content);
    expectBadInput([&] { readCalibration(path, "P0", "P1", {}); }, words);
  }
  void refuseTable(const std::string& content, const std::vector<std::string>& words) {
    const auto path = folder_.write("frames.csv", content);
    expectBadInput([&] { readFrameTable(path); }, words);
  }
  void refusePoints(const std::string& content, const std::vector<std::string>& words) {
    const auto path = folder_.write("p.bin", content);
    expectBadInput([&] { readPoints(path); }, words);
  }
  void refuseImage(const std::string& content, const std::vector<std::string>& words) {
    const auto path = folder_.write("i.png", content);
    expectBadInput([&] { readImage(path); }, words);
  }
  static std::string encoded(const cv::Mat& image, const char* ending) {
    std::vector<unsigned char> bytes;
    cv::imencode(ending, image, bytes);
    return {bytes.begin(), bytes.end()};
  }

  TemporaryFolder folder_;
};

TEST_F(Files, CalibrationGivesTheCamera) {
  const auto path =
      folder_.write("calib.txt", "# made by hand\ncalib_time: 09-Jan\n" + kLeft +
                                     "P1: 700 0 600 -350 0 710 180 0 0 0 1 0\nTr: 1 2 3\n");
  CameraMount mount;
  mount.z = 1.5;
  const StereoCamera camera = readCalibration(path, "P0", "P1", mount);
  EXPECT_EQ(camera.fx, 700.0);
  EXPECT_EQ(camera.fy, 710.0);
  EXPECT_EQ(camera.cx, 600.0);
  EXPECT_EQ(camera.cy, 180.0);
  EXPECT_DOUBLE_EQ(camera.baseline, 0.5);
  EXPECT_EQ(camera.mount.y, 0.0);
  EXPECT_EQ(camera.mount.z, 1.5);
}

TEST_F(Files, ALeftCameraBesideTheOriginMovesTheMount) {
  const auto path = folder_.write("calib.txt",
                                  "P2: 700 0 600 70 0 700 180 0 0 0 1 0\n"
                                  "P3: 700 0 600 -280 0 700 180 0 0 0 1 0\n");
  const StereoCamera ahead = readCalibration(path, "P2", "P3", {});
  EXPECT_DOUBLE_EQ(ahead.baseline, 0.5);
  EXPECT_NEAR(ahead.mount.y, 0.1, 1e-12);  // 0.1 m to the left
  EXPECT_NEAR(ahead.mount.x, 0.0, 1e-12);
  CameraMount to_the_left;
  to_the_left.yaw = kPi / 2.0;
  const StereoCamera turned = readCalibration(path, "P2", "P3", to_the_left);
  EXPECT_NEAR(turned.mount.x, -0.1, 1e-12);  // its left is behind
  EXPECT_NEAR(turned.mount.y, 0.0, 1e-12);
}

TEST_F(Files, CalibrationReadsBack) {
  const StereoCamera camera{721.54, 720.1, 609.56, 172.85, 0.537, {}};
  const test::CommaLocale comma;
  const auto path = folder_.write("calib.txt", formatCalibration(camera));
  const StereoCamera again = readCalibration(path, "P0", "P1", {});
  EXPECT_EQ(again.fx, camera.fx);
  EXPECT_EQ(again.fy, camera.fy);
  EXPECT_EQ(again.cx, camera.cx);
  EXPECT_EQ(again.cy, camera.cy);
  EXPECT_NEAR(again.baseline, camera.baseline, 1e-12);
}

TEST_F(Files, BadCalibrationsAreRefused) {
  refuseCalibration("", {"calib.txt", "no line P0"});
  refuseCalibration(kLeft, {"no line P1"});
  refuseCalibration(kLeft + kLeft, {"line 2: P0", "twice"});
  refuseCalibration(kLeft + "P1: 700 0 600 -350\n", {"line 2: P1", "4 numbers"});
  refuseCalibration(kLeft + "P1: 700 0 600 nan 0 710 180 0 0 0 1 0\n", {"line 2: P1", "nan"});
  refuseCalibration(kLeft + "P1: 700 0 600 0 0 710 180 0 0 0 1 0\n", {"baseline of 0 m", "> 0"});
  refuseCalibration(kLeft + "P1: 700 0 600 350 0 710 180 0 0 0 1 0\n", {"baseline of -0.5 m"});
  refuseCalibration(kLeft + "P1: 700 0 600 -3.5e6 0 710 180 0 0 0 1 0\n", {"baseline of 5000 m"});
  refuseCalibration(kLeft + "P1: 0 0 600 -350 0 710 180 0 0 0 1 0\n", {"line 2: P1", "projection"});
  refuseCalibration(kLeft + "P1: 700 5 600 -350 0 710 180 0 0 0 1 0\n", {"projection"});
  refuseCalibration(kLeft + "P1: 720 0 600 -350 0 710 180 0 0 0 1 0\n", {"fx", "700 left"});
  refuseCalibration(kLeft + "P1: 700 0 610 -350 0 710 180 0 0 0 1 0\n", {"cx", "rectified"});
  refuseCalibration(kLeft + "P1: 700 0 600 -350 0 710 190 0 0 0 1 0\n", {"cy"});
}

TEST_F(Files, TableFindsColumnsByName) {
  const auto rows = readFrameTable(folder_.write("frames.csv",
                                                 "points,note,time_s,frame,stop,pan_deg\r\n"
                                                 "# a comment\r\n"
                                                 "p/1.bin,x,0.5,7,,\r\n"
                                                 "p/2.bin,,1.5,8,3,-90\r\n"
                                                 "p/3.bin,,1.5,8,3,90\r\n"));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].frame, 7);
  EXPECT_EQ(rows[0].time_s, 0.5);
  EXPECT_FALSE(rows[0].stop);
  EXPECT_EQ(rows[0].points, "p/1.bin");
  EXPECT_EQ(rows[0].left, "");
  EXPECT_EQ(rows[1].stop, 3);
  EXPECT_DOUBLE_EQ(rows[1].pan, -kPi / 2.0);
  EXPECT_DOUBLE_EQ(rows[2].pan, kPi / 2.0);
}

TEST_F(Files, TableReadsBack) {
  FrameRow moving{3, 0.1, std::nullopt, 0.0, "l.png", "r.png", ""};
  FrameRow standing{4, 1.0 / 3.0, 2, toRadians(45), "", "", "p.bin"};
  const test::CommaLocale comma;
  const auto rows = readFrameTable(folder_.write(
      "frames.csv", frameTableHeader() + formatFrameRow(moving) + formatFrameRow(standing)));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].right, "r.png");
  EXPECT_FALSE(rows[0].stop);
  EXPECT_EQ(rows[1].time_s, standing.time_s);
  EXPECT_EQ(rows[1].stop, 2);
  EXPECT_DOUBLE_EQ(rows[1].pan, standing.pan);
  EXPECT_EQ(rows[1].points, "p.bin");
}

TEST_F(Files, BadTablesAreRefused) {
  const std::string header = "frame,time_s,stop,pan_deg,left,right,points\n";
  const std::string row = "1,1,,,,,p\n";
  refuseTable("", {"frames.csv", "no rows"});
  refuseTable(header, {"no rows"});
  refuseTable("time_s,points\n1,p\n", {"line 1", "no column frame"});
  refuseTable("frame,points\n1,p\n", {"line 1", "no column time_s"});
  refuseTable("frame,time_s,frame\n1,1,1\n", {"line 1: frame", "twice"});
  refuseTable(header + "1,1,,,,p\n", {"line 2", "6 fields", "7"});
  refuseTable(header + "x,1,,,,,p\n", {"line 2: frame", "\"x\""});
  refuseTable(header + "-1,1,,,,,p\n", {"line 2: frame", "-1"});
  refuseTable(header + "1.5,1,,,,,p\n", {"line 2: frame"});
  refuseTable(header + "1,inf,,,,,p\n", {"line 2: time_s", "inf"});
  refuseTable(header + "1,1,a,,,,p\n", {"line 2: stop"});
  refuseTable(header + "1,1,1,left,,,p\n", {"line 2: pan_deg"});
  refuseTable(header + row + "2,0.5,,,,,p\n", {"line 3: time_s", "0.5 after 1"});
  refuseTable(header + row + "2,1,,,,,p\n", {"line 3: time_s", "1 after 1"});
  refuseTable(header + row + "1,2,,,,,p\n", {"line 3: frame", "1 after 1"});
  refuseTable(header + "1,1,,,l,,\n", {"line 2", "one image of a pair"});
  refuseTable(header + "1,1,,,,,\n", {"line 2", "neither images nor points"});
  refuseTable(header + "1,1,,,,,/etc/passwd\n", {"line 2: points", "inside the folder"});
  refuseTable(header + "1,1,,,../l,r,\n", {"line 2: left", "inside the folder"});
  refuseTable(header + "1,1,,,l,a/../../r,\n", {"line 2: right", "inside the folder"});
  refuseTable(header + "1,1,5,0,,,p\n2,2,6,0,,,p\n3,3,5,0,,,p\n", {"line 4: stop", "second time"});
  std::string one_stop = header;
  for (int i = 0; i < 101; ++i) one_stop += "1,1,5,0,,,p\n";
  refuseTable(one_stop, {"line 102: stop: found stop 5 in one more row, expected at most 100"});
}

TEST_F(Files, PointsReadBack) {
  const std::vector<RangePoint> points = {{1.5f, -2, 0.25f, 1}, {500, 0, 0, 0}};
  const auto again = readPoints(folder_.write("p.bin", test::pointBytes(points)));
  EXPECT_EQ(test::pointBytes(again), test::pointBytes(points));
}

TEST_F(Files, APointThatIsNotFiniteIsLeftOut) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto points = readPoints(folder_.write(
      "p.bin", test::pointBytes({{1, 2, 3, 1}, {kNan, 2, 3, 1}, {1, kInfinity, 3, 1}})));
  EXPECT_EQ(test::pointBytes(points), test::pointBytes({{1, 2, 3, 1}}));
}

TEST_F(Files, AnEmptyFileIsAScanInWhichNothingCameBack) {
  EXPECT_TRUE(readPoints(folder_.write("p.bin", "")).empty());
}

TEST_F(Files, WithoutLikelihoodItIsOne) {
  const std::vector<float> xyz{1, 2, 3, 4, -5, 6, 7, 8, 9, 10, 11, -12};
  for (const std::size_t points : {3U, 4U}) {
    const std::string bytes(reinterpret_cast<const char*>(xyz.data()), 12 * points);
    const auto read = readPoints(folder_.write("p.bin", bytes));
    ASSERT_EQ(read.size(), points);
    EXPECT_EQ(read[1].y, -5.0F);
    EXPECT_EQ(read[1].w, 1.0F);
  }
}

TEST_F(Files, APartOfAPointsFile) {
  const std::vector<RangePoint> points = {{1, 2, 3, 1}, {4, 5, 6, 1}, {7, 8, 9, 1}};
  const std::string file = folder_.write("p.bin", test::pointBytes(points)).string();
  EXPECT_EQ(readPoints(file + "@16+32")[0].x, 4.0F);
  EXPECT_TRUE(readPoints(file + "@48+0").empty());
  expectBadInput([&] { readPoints(file + "@32+32"); }, {"p.bin", "48 bytes", "from byte 32"});
}

TEST_F(Files, BadPointsAreRefused) {
  refusePoints(std::string(17, 'x'), {"17 bytes", "16 bytes a point"});
  refusePoints(test::pointBytes({{1, 2, 3, 1.5f}}), {"1 points with w outside"});
  refusePoints(test::pointBytes({{1, 2, 3, -0.5f}, {1, 2, 3, 2}}), {"2 points with w"});
  refusePoints(test::pointBytes({{1, 2, 3, 200}, {1, 2, 3, 90}, {1, 2, 3, 4}}), {"no intensity"});
  expectBadInput([&] { readPoints(folder_.path() / "none.bin"); }, {"none.bin", "no such file"});
  const auto huge = folder_.write("huge.bin", "");
  std::filesystem::resize_file(huge, (64u << 20) + 16);
  expectBadInput([&] { readPoints(huge); }, {"huge.bin", "at most"});
}

TEST_F(Files, ImagesOfBothKindsAreRead) {
  for (const int type : {CV_8UC1, CV_8UC3}) {
    const cv::Mat image = test::exampleImage(1, 40, 30, type);
    const auto png = folder_.path() / "i.png";
    writePng(image, png);
    EXPECT_TRUE(test::sameImage(readImage(png), image));
    const cv::Mat lossy = readImage(folder_.write("i.jpg", encoded(image, ".jpg")));
    EXPECT_EQ(lossy.size(), image.size());
    EXPECT_EQ(lossy.type(), image.type());
  }
}

TEST_F(Files, BadImagesAreRefused) {
  const cv::Mat image = test::exampleImage(1, 200, 100);
  const std::string png = encoded(image, ".png");
  const std::string jpeg = encoded(image, ".jpg");
  expectBadInput([&] { readImage(folder_.path() / "none.png"); }, {"none.png", "no such file"});
  refuseImage("", {"i.png", "an empty file"});
  refuseImage("hello", {"no image"});
  refuseImage(encoded(image, ".bmp"), {"no image", "PNG or JPEG"});
  refuseImage(jpeg.substr(0, jpeg.size() / 2), {"cut off"});
  refuseImage(png.substr(0, png.size() / 2), {"cut off"});
  refuseImage(png.substr(0, 20), {"no image"});
  refuseImage(encoded(cv::Mat(9, 9, CV_16UC1, cv::Scalar(5)), ".png"), {"1 channels of 16 bits"});
  refuseImage(encoded(cv::Mat(9, 9, CV_8UC4, cv::Scalar(5)), ".png"), {"4 channels of 8 bits"});
  // A header that promises far more than there is.
  std::string huge = png;
  huge.replace(16, 8, std::string("\x00\x01\x00\x00\x00\x01\x00\x00", 8));
  refuseImage(huge, {"65536 × 65536 pixels", "64 megapixels"});
  huge.replace(16, 8, std::string(8, '\xff'));  // more pixels than 63 bits count
  refuseImage(huge, {"4294967295 × 4294967295 pixels", "64 megapixels"});
}

TEST_F(Files, DamagedImagesNeverCrash) {
  RandomStream random(5);
  for (const char* ending : {".png", ".jpg"}) {
    const std::string good = encoded(test::exampleImage(1, 60, 40), ending);
    for (int trial = 0; trial < 100; ++trial) {
      std::string bytes = good;
      for (int i = 0; i < 3; ++i) {
        const int at = random.index(static_cast<int>(bytes.size()));
        bytes[static_cast<std::size_t>(at)] = static_cast<char>(random.index(256));
      }
      if (trial % 3 == 0) {
        bytes.resize(static_cast<std::size_t>(random.index(static_cast<int>(bytes.size()))));
      }
      try {
        EXPECT_FALSE(readImage(folder_.write("i.png", bytes)).empty());
      } catch (const Error&) {
      }
    }
  }
}

}  // namespace
}  // namespace handmap
