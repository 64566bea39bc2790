#include <QCoreApplication>
#include <QElapsedTimer>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "drivers/camera/frame_check.h"
#include "drivers/camera/pair_matcher.h"
#include "drivers/camera/video_camera.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

/// A picture of the world: no two of them are the same.
cv::Mat picture(int number, cv::Size size = {64, 48}) {
  cv::Mat image(size, CV_8UC3);
  cv::RNG random(static_cast<std::uint64_t>(number) + 1);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

TEST(FrameCheck, KnowsARepeatedImageAndAFrozenCamera) {
  FrameCheck check;
  EXPECT_EQ(check(picture(0)), FrameFault::None);
  for (int i = 1; i <= kFrozen; ++i) {
    EXPECT_EQ(check(picture(0)), FrameFault::Repeated);
    EXPECT_EQ(check.repeatedInARow(), i);
  }
  EXPECT_EQ(check(picture(1)), FrameFault::None);
  EXPECT_EQ(check.repeatedInARow(), 0);
}

TEST(FrameCheck, KnowsHalfAnImage) {
  FrameCheck check;
  cv::Mat half = picture(0);
  half.rowRange(30, 48).setTo(cv::Scalar(128, 128, 128));
  EXPECT_EQ(check(half), FrameFault::Half);
  cv::Mat sill = picture(1);
  sill.rowRange(44, 48).setTo(cv::Scalar(0, 0, 0));  // the robot's own edge
  EXPECT_EQ(check(sill), FrameFault::None);
  // A covered camera is not half an image; who looks at the picture says what it is.
  EXPECT_EQ(check(cv::Mat(48, 64, CV_8UC3, cv::Scalar(0, 0, 0))), FrameFault::None);
}

TEST(FrameCheck, KnowsAnotherSize) {
  FrameCheck first;
  EXPECT_EQ(first(picture(0)), FrameFault::None);
  EXPECT_EQ(first(picture(1, {32, 24})), FrameFault::WrongSize);
  EXPECT_EQ(first(cv::Mat()), FrameFault::WrongSize);
  FrameCheck asked({640, 480});
  EXPECT_EQ(asked(picture(0)), FrameFault::WrongSize);
}

TEST(PairMatcher, PutsTogetherWhatWasTakenTogether) {
  PairMatcher matcher(0.0);
  EXPECT_FALSE(matcher.add(Side::Left, {1.000, picture(0)}));
  const auto pair = matcher.add(Side::Right, {1.004, picture(1)});
  ASSERT_TRUE(pair);
  EXPECT_EQ(pair->time_s, 1.000);
  EXPECT_EQ(cv::norm(pair->left, picture(0)), 0.0);
  EXPECT_EQ(cv::norm(pair->right, picture(1)), 0.0);
  EXPECT_FALSE(matcher.add(Side::Right, {1.005, picture(2)})) << "each once";
  EXPECT_EQ(matcher.unmatched(), 0);
}

TEST(PairMatcher, CountsWhatHasNoPair) {
  PairMatcher matcher(0.0);
  matcher.add(Side::Left, {1.0, picture(0)});
  matcher.add(Side::Left, {1.1, picture(1)});
  EXPECT_TRUE(matcher.add(Side::Right, {1.1, picture(2)}));
  EXPECT_EQ(matcher.unmatched(), 1);
  for (int i = 0; i < 10; ++i) matcher.add(Side::Left, {2.0 + 0.1 * i, picture(i)});
  EXPECT_GT(matcher.unmatched(), 5);
}

TEST(PairMatcher, AKnownDelayIsTakenOff) {
  PairMatcher blind(0.0);
  PairMatcher knows(0.015);
  for (PairMatcher* matcher : {&blind, &knows}) matcher->add(Side::Left, {1.0, picture(0)});
  EXPECT_FALSE(blind.add(Side::Right, {1.016, picture(1)}));
  EXPECT_NEAR(blind.offset_s(), 0.016, 1e-9);
  EXPECT_TRUE(knows.add(Side::Right, {1.016, picture(1)}));
}

/// A video of so many pictures, side by side or of one camera.
std::string video(const test::TemporaryFolder& folder, const char* name, cv::Size size, int frames,
                  int first = 0) {
  const std::string path = (folder.path() / name).string();
  cv::VideoWriter writer(path, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0, size);
  for (int i = 0; i < frames; ++i) {
    cv::Mat image = picture(first + i, size);
    cv::GaussianBlur(image, image, {}, 2.0);
    writer.write(image);
  }
  return path;
}

struct Heard {
  explicit Heard(VideoCamera& camera) {
    QObject::connect(&camera, &Device::stateChanged, &camera,
                     [this](DeviceState state, const QString& detail) {
                       states.push_back(state);
                       last_detail = detail.toStdString();
                     });
    QObject::connect(&camera, &PairCamera::pairTaken, &camera,
                     [this](double time_s, const cv::Mat& left, const cv::Mat& right) {
                       times.push_back(time_s);
                       left_size = left.size();
                       right_size = right.size();
                     });
  }
  bool saw(DeviceState state) const {
    return std::find(states.begin(), states.end(), state) != states.end();
  }
  std::vector<DeviceState> states;
  std::string last_detail;
  std::vector<double> times;
  cv::Size left_size;
  cv::Size right_size;
};

/// Lets events be handled until it holds, for 20 s at most.
bool eventually(const std::function<bool()>& holds) {
  QElapsedTimer timer;
  timer.start();
  while (!holds() && timer.elapsed() < 20'000) {
    QCoreApplication::processEvents(QEventLoop::AllEvents, 50);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return holds();
}

TEST(VideoCamera, PlaysAVideoWithBothImagesSideBySideToItsEnd) {
  const test::TemporaryFolder folder;
  CameraRig rig;
  rig.left = video(folder, "both.avi", {128, 48}, 12);
  VideoCamera camera(rig, startedRigClock(), [](const std::string&) {});
  Heard heard(camera);
  camera.open();
  EXPECT_TRUE(eventually([&] { return heard.saw(DeviceState::Lost); }));
  EXPECT_TRUE(heard.saw(DeviceState::Ready));
  EXPECT_NE(heard.last_detail.find("at its end"), std::string::npos) << heard.last_detail;
  EXPECT_GE(heard.times.size(), 8U);
  for (std::size_t i = 1; i < heard.times.size(); ++i) {
    EXPECT_GT(heard.times[i], heard.times[i - 1]);
  }
  EXPECT_EQ(heard.left_size, cv::Size(64, 48));
  EXPECT_EQ(heard.right_size, cv::Size(64, 48));
  camera.close();
  EXPECT_EQ(heard.states.back(), DeviceState::Closed);
}

TEST(VideoCamera, SaysWhatCannotBeOpenedAndTriesAgain) {
  const test::TemporaryFolder folder;
  CameraRig rig;
  rig.left = (folder.path() / "later.avi").string();
  VideoCamera camera(rig, startedRigClock(), [](const std::string&) {});
  Heard heard(camera);
  camera.open();
  ASSERT_TRUE(eventually([&] { return heard.saw(DeviceState::Lost); }));
  EXPECT_NE(heard.last_detail.find("later.avi: cannot be opened"), std::string::npos);
  const std::string made = video(folder, "now.avi", {128, 48}, 60);
  std::filesystem::rename(made, rig.left);
  EXPECT_TRUE(eventually([&] { return heard.saw(DeviceState::Ready); })) << "it is back";
  camera.close();
}

TEST(VideoCamera, ACameraThatStandsStillIsFrozen) {
  const test::TemporaryFolder folder;
  CameraRig rig;
  rig.left = (folder.path() / "still.avi").string();
  {
    cv::VideoWriter writer(rig.left, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0, {128, 48});
    cv::Mat image = picture(0, {128, 48});
    for (int i = 0; i < 12; ++i) writer.write(image);
  }
  int refused = 0;
  VideoCamera camera(rig, startedRigClock(), [&](const std::string& reason) {
    refused += reason == "repeated image" ? 1 : 0;
  });
  Heard heard(camera);
  camera.open();
  EXPECT_TRUE(eventually([&] { return heard.saw(DeviceState::Degraded); }));
  EXPECT_EQ(heard.times.size(), 1U);
  EXPECT_GE(refused, kFrozen);
  camera.close();
}

TEST(VideoCamera, SaysThatTheSizeIsNotTheOneAskedFor) {
  const test::TemporaryFolder folder;
  CameraRig rig;
  rig.left = video(folder, "small.avi", {128, 48}, 40);
  rig.width = 1280;
  rig.height = 480;
  VideoCamera camera(rig, startedRigClock(), [](const std::string&) {});
  Heard heard(camera);
  camera.open();
  ASSERT_TRUE(eventually([&] { return heard.saw(DeviceState::Degraded); }));
  EXPECT_EQ(heard.last_detail, "found images of 128 × 48 pixels, expected 1280 × 480");
  EXPECT_TRUE(heard.times.empty());
  camera.close();
}

TEST(VideoCamera, MatchesTwoDevices) {
  const test::TemporaryFolder folder;
  CameraRig rig;
  rig.left = video(folder, "left.avi", {64, 48}, 80, 0);
  rig.right = video(folder, "right.avi", {64, 48}, 80, 100);
  long unmatched = 0;
  VideoCamera camera(rig, startedRigClock(), [&](const std::string&) { ++unmatched; });
  Heard heard(camera);
  camera.open();
  // Two files that begin when their threads do: whether their images come within 10 ms is chance,
  // that each is either in a pair or counted is not.
  EXPECT_TRUE(eventually([&] { return heard.times.size() > 3 || unmatched > 10; }));
  camera.close();
}

}  // namespace
}  // namespace handmap
