// A Vision camera: the one that comes with Aravis and is none.
#include <algorithm>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "drivers/camera/aravis_device.h"

#ifdef HANDMAP_ARAVIS
#include <arv.h>

#include "core/base/error.h"
#include "core/rig/rig_clock.h"

namespace handmap {
namespace {

constexpr auto kFake = "Fake_1";

class Aravis : public testing::Test {
 protected:
  Aravis() { arv_enable_interface("Fake"); }
  const RigClock clock_ = startedRigClock();
};

TEST_F(Aravis, ListsWhatIsThere) {
  const auto cameras = aravisCameras();
  EXPECT_NE(std::find(cameras.begin(), cameras.end(), kFake), cameras.end());
}

TEST_F(Aravis, GivesImagesOfTheSizeAndRateAskedFor) {
  const auto device = aravisDevice({kFake, 320, 240, 20.0}, clock_)();
  double last_s = -1.0;
  cv::Mat last;
  for (int i = 0; i < 10; ++i) {
    const auto image = device->next({});
    ASSERT_TRUE(image) << i;
    EXPECT_EQ(image->image.size(), cv::Size(320, 240));
    EXPECT_EQ(image->image.type(), CV_8UC1);
    EXPECT_GT(image->time_s, last_s);
    EXPECT_LE(image->time_s, clock_());
    if (!last.empty()) {
      EXPECT_GT(cv::norm(image->image, last), 0.0) << "a picture of its own";
    }
    last_s = image->time_s;
    last = image->image;
  }
  EXPECT_FALSE(device->hasEnd());
}

TEST_F(Aravis, AStopEndsTheWait) {
  const auto device = aravisDevice({kFake, 0, 0, 0.0}, clock_)();
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(device->next(stop.get_token()));
}

TEST_F(Aravis, SaysWhatCannotBeOpened) {
  try {
    aravisDevice({"None-123", 0, 0, 0.0}, clock_)();
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("None-123: cannot open it"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace handmap
#endif
