// A FireWire stereo head, with a fake in place of libdc1394.
#include <deque>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "drivers/camera/iidc_device.h"
#include "drivers/camera/image_devices.h"

namespace handmap {
namespace {

constexpr std::uint64_t kNumber = 0x00b09d0100abcdef;

/// Sends what was put into it; an empty optional is a moment without a frame.
struct FakeHead {
  std::vector<std::uint64_t> there{kNumber};
  std::deque<std::optional<IidcFrame>> frames;
  std::uint32_t bayer = 0;
  std::uint64_t begun = 0;
  int open_frames = 0;
  int ended = 0;
};

class FakeCamera : public IidcCamera {
 public:
  explicit FakeCamera(FakeHead& head) : head_(head) {}
  ~FakeCamera() override { ++head_.ended; }
  std::vector<std::uint64_t> identities() override { return head_.there; }
  void begin(std::uint64_t identity) override { head_.begun = identity; }
  std::uint32_t bayerRegister() override { return head_.bayer; }
  std::optional<IidcFrame> poll() override {
    if (head_.frames.empty()) return std::nullopt;
    const auto frame = head_.frames.front();
    head_.frames.pop_front();
    if (frame) ++head_.open_frames;
    return frame;
  }
  void done() override { --head_.open_frames; }

 private:
  FakeHead& head_;
};

class Iidc : public testing::Test {
 protected:
  std::unique_ptr<ImageDevice> open(const std::string& source = "first") {
    return iidcDevice(
        source, [this] { return std::make_unique<FakeCamera>(head_); },
        [this] { return now_s_ += 0.01; })();
  }
  std::string whyNot(const std::string& source) {
    try {
      open(source);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  }
  /// 4 × 2 pixels: byte i of each pixel is 50·i plus the column.
  IidcFrame frame(int images) {
    bytes_.clear();
    for (int pixel = 0; pixel < 8; ++pixel) {
      for (int i = 0; i < images; ++i) {
        bytes_.push_back(static_cast<std::uint8_t>(50 * i + pixel % 4));
      }
    }
    return {bytes_.data(), 4, 2, images, 0.25, false};
  }

  FakeHead head_;
  double now_s_ = 100.0;
  std::vector<std::uint8_t> bytes_;
};

TEST_F(Iidc, TheRightImageComesFirst) {
  for (const int images : {2, 3}) {
    head_.frames = {std::nullopt, frame(images)};
    const auto device = open();
    const auto image = device->next({});
    ASSERT_TRUE(image);
    ASSERT_EQ(image->image.size(), cv::Size(8, 2)) << "left and right side by side";
    EXPECT_EQ(image->image.at<std::uint8_t>(1, 0), 50 * (images - 1)) << "the left one";
    EXPECT_EQ(image->image.at<std::uint8_t>(1, 7), 3) << "the right one";
    EXPECT_NEAR(image->time_s, now_s_ - 0.25, 0.05) << "when it was taken";
    EXPECT_EQ(head_.open_frames, 0) << "given back";
    EXPECT_EQ(head_.begun, kNumber);
  }
  EXPECT_EQ(head_.ended, 2);
}

TEST_F(Iidc, AColourHeadGivesColour) {
  head_.bayer = 0x52474742;
  head_.frames = {frame(2)};
  EXPECT_EQ(open()->next({})->image.type(), CV_8UC3);
}

TEST_F(Iidc, ADamagedFrameIsLeftOut) {
  IidcFrame damaged = frame(2);
  damaged.damaged = true;
  head_.frames = {damaged, damaged, frame(2)};
  ASSERT_TRUE(open()->next({}));
  EXPECT_TRUE(head_.frames.empty());
  EXPECT_EQ(head_.open_frames, 0);
}

TEST_F(Iidc, ASilentHeadIsLost) {
  const auto device = open();
  EXPECT_FALSE(device->next({}));
  EXPECT_GT(now_s_, 102.0);
  EXPECT_FALSE(device->hasEnd()) << "it is tried again";
}

TEST_F(Iidc, SaysWhatIsWrong) {
  EXPECT_EQ(whyNot("00b09d0100abcdef"), "");
  EXPECT_EQ(whyNot("00b09d0100000000"),
            "the FireWire camera 00b09d0100000000 does not answer; 00b09d0100abcdef does");
  EXPECT_NE(whyNot("bumblebee").find("expected its number (hexadecimal) or \"first\""),
            std::string::npos);
  head_.frames = {frame(1)};
  EXPECT_THROW(open()->next({}), Error) << "no stereo head";
  head_.there.clear();
  EXPECT_EQ(whyNot("first"),
            "no FireWire camera answers: is it connected, and may you use /dev/fw*?");
}

TEST_F(Iidc, EveryKindOfCameraIsThereOrSaysThatItIsNot) {
  for (const CameraKind kind : {CameraKind::FireWire, CameraKind::Vision}) {
    CameraRig rig;
    rig.kind = kind;
    rig.left = "none-such";
    EXPECT_THROW(imageDevice(
                     rig, rig.left, [] { return 0.0; }, 0.0)(),
                 Error);
  }
}

}  // namespace
}  // namespace handmap
