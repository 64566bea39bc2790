#include "core/session/redone_acts.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

Map remembered() {
  Map map;
  for (const char* id : {"A", "B"}) {
    Building building;
    building.id = id;
    building.shape = Rectangle{{0.0, 0.0}, 10.0, 10.0, 0.0};
    map.buildings.push_back(building);
  }
  return map;
}

Act poseAt(double time_s, double x) {
  return {time_s, Act::Kind::RobotIsHere, {x, 0.0, 0.0}, {}, {}};
}

TEST(RedoneActs, BuildingsAreHeldAndTakenOut) {
  const Rectangle right{{3.0, 4.0}, 11.0, 9.0, 0.1};
  const std::vector<Act> acts = {{1.0, Act::Kind::BuildingIsRight, {}, "A", right},
                                 {2.0, Act::Kind::BuildingIsNotThere, {}, "B", {}}};
  const RedoneActs done = redone(remembered(), acts);
  ASSERT_EQ(done.drawing.buildings.size(), 1U);
  EXPECT_EQ(std::get<Rectangle>(done.drawing.buildings[0].shape), right);
  EXPECT_TRUE(done.drawing.buildings[0].fixed);
  EXPECT_TRUE(done.unmatched.empty());
  // On what the drive ended with nothing is new.
  EXPECT_EQ(redone(done.drawing, acts).drawing, done.drawing);
}

TEST(RedoneActs, PosesComeInOrderTheLastOfAMomentCounts) {
  const std::vector<Act> acts = {poseAt(5.0, 1.0), poseAt(2.0, 2.0), poseAt(5.0, 3.0)};
  const RedoneActs done = redone(remembered(), acts);
  ASSERT_EQ(done.poses.size(), 2U);
  EXPECT_EQ(done.poses[0].time_s, 2.0);
  EXPECT_EQ(done.poses[1].pose.x, 3.0);
}

TEST(RedoneActs, WhatWasForgottenStaysForgotten) {
  const std::vector<Act> acts = {
      poseAt(1.0, 1.0), {2.0, Act::Kind::ForgetPoses, {}, {}, {}}, poseAt(3.0, 2.0)};
  EXPECT_EQ(redone(remembered(), acts).poses.size(), 1U);
}

TEST(RedoneActs, ABuildingThatTheDrawingDoesNotHaveIsTold) {
  const std::vector<Act> acts = {
      {1.0, Act::Kind::BuildingIsRight, {}, "Z", Rectangle{{0.0, 0.0}, 1.0, 1.0, 0.0}}};
  EXPECT_EQ(redone(remembered(), acts).unmatched, std::vector<std::string>{"Z"});
}

}  // namespace
}  // namespace handmap
