// The virtual rig with a stereo head: rendered images, emulated head and wheels, real drivers.
#include "drivers/virtual/stereo_rig.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/recording/recording.h"
#include "core/simulation/drive.h"
#include "drivers/live/live_source.h"
#include "drivers/virtual/stop_and_go.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

std::vector<StampedPose> line(double step_m) {
  std::vector<StampedPose> poses;
  for (int i = 0; i < 3; ++i) poses.push_back({2.0 * i, {step_m * i, 0.0, 0.0}});
  return poses;
}

TEST(StopAndGo, DrivesOnWhenTheHeadHasLookedAround) {
  StopAndGo robot(line(5.0), line(4.0));
  double now = 0.0;
  const auto pass = [&](double seconds, bool head_away) {
    for (const double end = now + seconds; now < end; now += 0.02) robot.tick(now, head_away);
  };
  pass(20.0, false);
  EXPECT_EQ(robot.pose().x, 0.0) << "nobody has looked yet";
  pass(5.0, true);
  EXPECT_EQ(robot.pose().x, 0.0);
  pass(0.4, false);
  EXPECT_EQ(robot.pose().x, 0.0) << "the head has just come back";
  pass(1.2, false);
  EXPECT_NEAR(robot.pose().x, 2.5, 0.5) << "on its way";
  EXPECT_NEAR(robot.odometry().x, 0.8 * robot.pose().x, 1e-9);
  pass(3.0, false);
  EXPECT_NEAR(robot.pose().x, 5.0, 1e-9);
  pass(70.0, false);
  EXPECT_NEAR(robot.pose().x, 10.0, 1e-9) << "who drives it waits a minute, not for ever";
  pass(100.0, true);
  EXPECT_NEAR(robot.pose().x, 10.0, 1e-9) << "the last stop";
}

TEST(StereoRig, LooksAroundAtEachStopAndDrivesOn) {
  VirtualDrive drive{furnished(twoRowWorld(3), 3), 3};
  drive.speed_m_s = 10.0;
  const LiveJob job{
      virtualStereoRig(), virtualStereoDevices(drive), std::make_shared<RigMonitor>(), {}};
  const auto source = openLive(job, {});
  ASSERT_TRUE(source);
  ASSERT_TRUE(source->info().camera);
  const auto stops = driveThrough(drive.world.map, atStep({}, 5.0), drive.seed).odometry;
  for (const std::size_t stop : {0U, 1U}) {
    const auto observation = source->next();
    ASSERT_TRUE(observation) << stop;
    EXPECT_TRUE(observation->standing);
    ASSERT_EQ(observation->views.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const View& view = observation->views[i];
      EXPECT_NEAR(view.pan, sixPans().pans[i], 1e-9);
      EXPECT_EQ(view.left.size(), view.right.size());
      EXPECT_EQ(view.left.cols, 480);
      if (i > 0) {
        EXPECT_GT(cv::norm(view.left, observation->views[i - 1].left, cv::NORM_L1),
                  4.0 * static_cast<double>(view.left.total()))
            << "another direction";
      }
    }
    // A base tells millimetres.
    EXPECT_NEAR(observation->odometry.x, stops[stop].pose.x, 0.002);
    EXPECT_NEAR(observation->odometry.y, stops[stop].pose.y, 0.002);
  }
  job.monitor->end();
}

TEST(StereoRig, APairThatIsSwappedOnTheWayIsNamedAndNotUsed) {
  VirtualDrive drive{furnished(twoRowWorld(3), 3), 3};
  drive.speed_m_s = 10.0;
  drive.faults = {{DeviceRole::Camera, FaultKind::Swap, 14.0, 28.0}};  // the second look around
  const LiveJob job{
      virtualStereoRig(), virtualStereoDevices(drive), std::make_shared<RigMonitor>(), {}};
  const auto source = openLive(job, {});
  ASSERT_TRUE(source);
  int used = 0;
  int refused = 0;
  while ((used < 2 || refused == 0) && used + refused < 6) {
    try {
      ASSERT_TRUE(source->next());
      ++used;
    } catch (const FrameError& error) {
      EXPECT_NE(std::string(error.what()).find("look swapped"), std::string::npos) << error.what();
      ++refused;
    }
  }
  job.monitor->end();
  EXPECT_GE(refused, 1);
  EXPECT_EQ(used, 2) << "before and after";
}

/// Each for a second or so, one after the other, while the robot drives, stands and looks around.
TEST(StereoRig, LiveEqualsReplayUnderEveryFault) {
  const test::TemporaryFolder folder;
  VirtualDrive drive{furnished(twoRowWorld(3), 3), 3};
  drive.speed_m_s = 10.0;
  double last_s = 3.0;
  for (const auto& [role, kind] : possibleFaults(VirtualRigKind::StereoHead)) {
    drive.faults.push_back({role, kind, last_s, last_s + 1.2});
    last_s += 1.6;
  }
  const LiveJob job{virtualStereoRig(), virtualStereoDevices(drive), std::make_shared<RigMonitor>(),
                    folder.path() / "drive"};
  std::vector<Observation> lived;
  {
    const auto source = openLive(job, {});
    while (source && (lived.empty() || lived.back().time_s < last_s)) {
      ASSERT_LT(job.monitor->now(), last_s + 60.0) << "it does not go on";
      try {
        lived.push_back(source->next().value());
      } catch (const FrameError&) {
        continue;
      }
    }
  }
  const auto source = replay(openRecording(job.record), {});
  for (const Observation& observation : lived) {
    const Observation again = source->next().value();
    EXPECT_EQ(again.time_s, observation.time_s);
    EXPECT_EQ(again.odometry, observation.odometry);
    ASSERT_EQ(again.views.size(), observation.views.size());
    for (std::size_t i = 0; i < again.views.size(); ++i) {
      EXPECT_EQ(again.views[i].pan, observation.views[i].pan);
      EXPECT_EQ(cv::norm(again.views[i].left, observation.views[i].left, cv::NORM_INF), 0.0);
      EXPECT_EQ(cv::norm(again.views[i].right, observation.views[i].right, cv::NORM_INF), 0.0);
    }
  }
  EXPECT_FALSE(source->next());
}

TEST(StereoRig, FaultsAreThoseThatSuchARigCanHave) {
  const auto possible = possibleFaults(VirtualRigKind::StereoHead);
  EXPECT_EQ(possible.size(), 20U);
  for (const auto& [role, kind] : possible) {
    const std::string text = std::string(nameOf(role)) + ":" + nameOf(kind) + "@3+2";
    const auto faults = parseFaults(text, VirtualRigKind::StereoHead);
    ASSERT_EQ(faults.size(), 1U) << text;
    EXPECT_EQ(faultAt(faults, role, 4.0), kind) << text;
  }
  EXPECT_THROW(parseFaults("scanner:drop@1+1", VirtualRigKind::StereoHead), Error);
  EXPECT_THROW(parseFaults("head:half@1+1", VirtualRigKind::StereoHead), Error);
  EXPECT_THROW(parseFaults("head:limit@1+1", VirtualRigKind::Laser), Error);
}

}  // namespace
}  // namespace handmap
