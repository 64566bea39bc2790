#include "core/estimation/smoothing/smoothing_graph.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

class StateLayoutTest : public testing::Test {
 protected:
  StateLayoutTest() : frames_(4), found_(2), landmarks_(2) {
    for (Frame& frame : frames_) pointers_.push_back(&frame);
    found_[0].id = FoundId{7};
    found_[1].id = FoundId{3};
    for (std::size_t i = 0; i < 3; ++i) frames_[i].sightings.push_back({0.0, 5.0, 0.1, 0.1, 1});
    frames_[0].sightings.push_back({0.0, 5.0, 0.1, 0.1, 0});
  }
  std::vector<Frame> frames_;
  std::vector<Frame*> pointers_;
  std::vector<FoundBox> found_;
  std::vector<Vec2> landmarks_;
};

TEST_F(StateLayoutTest, StatesStandOneAfterTheOther) {
  DrawingPrior drawing;
  const StateLayout layout({pointers_, 2, found_, landmarks_, {}, &drawing});
  EXPECT_EQ(layout.pose(1), smoothing::kNone);
  EXPECT_EQ(layout.pose(2), 0);
  EXPECT_EQ(layout.pose(3), 3);
  EXPECT_EQ(layout.lastPose(), 3);
  EXPECT_EQ(layout.box(std::size_t{0}), 6);
  EXPECT_EQ(layout.box(std::size_t{1}), 11);
  EXPECT_EQ(layout.landmark(0), smoothing::kNone);  // one frame alone saw it
  EXPECT_EQ(layout.landmark(1), 16);
  EXPECT_EQ(layout.bias(), 18);
  EXPECT_EQ(layout.scale(), 19);
  EXPECT_EQ(layout.motion(), 20);
  EXPECT_EQ(layout.size(), 24);
}

TEST_F(StateLayoutTest, BoxesAreFoundByTheirNames) {
  const StateLayout layout({pointers_, 1, found_, landmarks_});
  EXPECT_EQ(layout.indexOf(FoundId{7}), 0U);
  EXPECT_EQ(layout.indexOf(FoundId{3}), 1U);
}

TEST_F(StateLayoutTest, WhereAllPosesStayThereIsNoLastOne) {
  EXPECT_EQ(StateLayout({pointers_, 4, found_, landmarks_}).lastPose(), smoothing::kNone);
}

}  // namespace
}  // namespace handmap
