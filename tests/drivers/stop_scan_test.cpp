#include "drivers/live/stop_scan.h"

#include <gtest/gtest.h>

namespace handmap {
namespace {

using Kind = StopScan::Action::Kind;

constexpr Pose2 kHere{1.0, 2.0, 0.5};

StopRig threePans() {
  StopRig options;
  options.pans = {0.0, 1.0, -1.0};
  options.every_m = 1.0;
  return options;
}

/// Stands, and looks at the first pan.
StopScan begun(double time_s = 10.0) {
  StopScan scan(threePans());
  const auto action = scan.moved(time_s, kHere, 1.0);
  EXPECT_TRUE(action && action->kind == Kind::Look && action->pan == 0.0);
  return scan;
}

/// One whole look around from the first pan on; the last action.
std::optional<StopScan::Action> lookAround(StopScan& scan, double time_s) {
  std::optional<StopScan::Action> action;
  for (const double pan : {0.0, 1.0, -1.0}) {
    scan.arrived(time_s += 1.0, pan);
    const auto taken = scan.pairTaken(time_s += 0.5);
    EXPECT_TRUE(taken && taken->kind == Kind::Take && taken->pan == pan) << pan;
    action = scan.tick(time_s);
  }
  return action;
}

TEST(StopScan, LooksAroundWhereTheRobotStands) {
  StopScan scan(threePans());
  EXPECT_FALSE(scan.moved(1.0, kHere, 0.0));
  EXPECT_FALSE(scan.moved(1.9, kHere, 0.9));
  const auto first = scan.moved(2.0, kHere, 1.0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->kind, Kind::Look);
  const auto last = lookAround(scan, 2.0);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->kind, Kind::Deliver);
  EXPECT_EQ(last->pose, kHere);
  EXPECT_FALSE(scan.isLooking());
}

TEST(StopScan, TakesNoPairFromBeforeTheHeadHasSettled) {
  StopScan scan = begun(10.0);
  EXPECT_FALSE(scan.pairTaken(10.5));  // on the way
  scan.arrived(11.0, 0.0);
  EXPECT_FALSE(scan.pairTaken(10.9));  // exposed before it arrived
  EXPECT_FALSE(scan.pairTaken(11.05));
  EXPECT_TRUE(scan.pairTaken(11.2));
  EXPECT_FALSE(scan.pairTaken(11.3)) << "one pair a pan";
}

TEST(StopScan, AnArrivalElsewhereIsNone) {
  StopScan scan = begun(10.0);
  scan.arrived(11.0, 1.0);
  EXPECT_FALSE(scan.pairTaken(12.0));
}

TEST(StopScan, DoesNotLookTwiceAtOnePlace) {
  StopScan scan = begun();
  lookAround(scan, 10.0);
  EXPECT_FALSE(scan.moved(30.0, kHere, 15.0));
  const auto again = scan.moved(40.0, {2.1, 2.0, 0.5}, 1.0);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->kind, Kind::Look);
}

TEST(StopScan, APersonAsksForALookAround) {
  StopRig options = threePans();
  options.automatic = false;
  StopScan scan(options);
  EXPECT_FALSE(scan.moved(10.0, kHere, 5.0));
  scan.trigger();
  EXPECT_FALSE(scan.moved(10.1, kHere, 0.0)) << "not while it drives";
  EXPECT_TRUE(scan.moved(11.1, kHere, 1.0));
  lookAround(scan, 11.1);
  EXPECT_FALSE(scan.moved(30.0, kHere, 15.0)) << "once";
}

TEST(StopScan, WhoAsksSeesTheHeadGoAroundWithoutCameraAndWheels) {
  StopRig options = sixPans();
  options.automatic = false;
  StopScan scan(options);
  EXPECT_FALSE(scan.tick(1.0));
  scan.trigger();
  std::vector<double> pans;
  std::string reason;
  for (double now_s = 2.0; now_s < 60.0 && reason.empty(); now_s += 0.05) {
    const auto action = scan.tick(now_s);
    if (!action) continue;
    if (action->kind == StopScan::Action::Kind::Drop) reason = action->reason;
    if (action->kind != StopScan::Action::Kind::Look) continue;
    pans.push_back(action->pan);
    scan.arrived(now_s, action->pan);
  }
  EXPECT_EQ(pans, options.pans);
  EXPECT_FALSE(reason.empty()) << "there is nothing to be worked in";
  for (double now_s = 60.0; now_s < 70.0; now_s += 0.05) EXPECT_FALSE(scan.tick(now_s));
}

TEST(StopScan, DropsWhatItHasWhenTheRobotDrivesOn) {
  StopScan scan = begun();
  scan.arrived(11.0, 0.0);
  scan.pairTaken(12.0);
  EXPECT_FALSE(scan.moved(12.1, {1.02, 2.0, 0.5}, 0.0)) << "nudged";
  const auto action = scan.moved(12.2, {1.2, 2.0, 0.5}, 0.0);
  ASSERT_TRUE(action);
  EXPECT_EQ(action->kind, Kind::Drop);
  EXPECT_EQ(action->pan, 0.0);
  // The next stop begins with the first pan.
  const auto again = scan.moved(15.0, {1.2, 2.0, 0.5}, 1.0);
  ASSERT_TRUE(again);
  EXPECT_EQ(lookAround(scan, 15.0)->kind, Kind::Deliver);
}

TEST(StopScan, GivesUpOnAHeadOrACameraThatDoesNotAnswer) {
  StopScan scan = begun(10.0);
  EXPECT_FALSE(scan.tick(24.0));
  EXPECT_EQ(scan.tick(26.0)->kind, Kind::Drop);
  scan.moved(30.0, kHere, 1.0);
  scan.arrived(31.0, 0.0);
  EXPECT_FALSE(scan.tick(33.0));
  EXPECT_EQ(scan.tick(35.0)->kind, Kind::Drop);
  scan.moved(40.0, kHere, 1.0);
  EXPECT_EQ(scan.headLost()->kind, Kind::Drop);
  EXPECT_FALSE(scan.headLost());
}

}  // namespace
}  // namespace handmap
