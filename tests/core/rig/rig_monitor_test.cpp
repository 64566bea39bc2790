#include "core/rig/rig_monitor.h"

#include <chrono>

#include <gtest/gtest.h>

namespace handmap {
namespace {

struct Watched {
  double now = 0.0;
  RigMonitor monitor{[this] { return now; }};

  void deliver(DeviceRole role, double until_s, double period_s) {
    for (; now < until_s; now += period_s) monitor.datum(role, now);
  }
  DeviceStatus device() const { return monitor.status().devices.at(0); }
};

TEST(RigMonitor, NamesASilentDeviceWithinASecond) {
  Watched watched;
  watched.monitor.add(DeviceRole::Scanner);
  watched.monitor.setState(DeviceRole::Scanner, DeviceState::Ready, "");
  watched.deliver(DeviceRole::Scanner, 5.0, 0.1);
  EXPECT_EQ(watched.device().state, DeviceState::Ready);
  EXPECT_NEAR(watched.device().rate_hz, 10.0, 1.0);
  watched.now += 0.8;
  EXPECT_EQ(watched.device().state, DeviceState::Degraded);
  EXPECT_EQ(watched.device().detail.find("silent for "), 0U);
  EXPECT_EQ(watched.device().rate_hz, 0.0);
  watched.deliver(DeviceRole::Scanner, 7.0, 0.1);
  EXPECT_EQ(watched.device().state, DeviceState::Ready);
}

TEST(RigMonitor, TheRobotsTimeIsThatOfItsOwnClockWhereItIsKnown) {
  Watched watched;
  watched.now = 100.0;
  const auto this_machine = [] {
    const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
    return now.count();
  };
  const double before = this_machine();
  const double told = watched.monitor.robotTime(90.0);
  EXPECT_GE(told, before - 10.0 - 1e-6);
  EXPECT_LE(told, this_machine() - 10.0 + 1e-6);
  watched.monitor.stamped(DeviceRole::Odometry, 50.0, 8050.0);  // the rig has none
  watched.monitor.add(DeviceRole::Odometry);
  watched.monitor.add(DeviceRole::Scanner);
  watched.monitor.stamped(DeviceRole::Odometry, 50.0, 1050.25);
  EXPECT_EQ(watched.monitor.robotTime(90.0), 1090.25);
  watched.monitor.stamped(DeviceRole::Scanner, 50.0, 1050.5);  // by which observations are timed
  watched.monitor.stamped(DeviceRole::Odometry, 51.0, 1051.25);
  EXPECT_EQ(watched.monitor.robotTime(90.0), 1090.5);
}

TEST(RigMonitor, ASlowDeviceIsNotSilentBetweenItsData) {
  Watched watched;
  watched.monitor.add(DeviceRole::Camera);
  watched.monitor.setState(DeviceRole::Camera, DeviceState::Ready, "");
  watched.deliver(DeviceRole::Camera, 20.0, 1.0);
  watched.now += 1.5;
  EXPECT_EQ(watched.device().state, DeviceState::Ready);
  watched.now += 2.0;
  EXPECT_EQ(watched.device().state, DeviceState::Degraded);
}

TEST(RigMonitor, ADeviceWhoseClockIsOffIsNoYoungerForIt) {
  Watched watched;
  watched.monitor.add(DeviceRole::Odometry);
  watched.monitor.setState(DeviceRole::Odometry, DeviceState::Ready, "");
  watched.now = 10.0;
  watched.monitor.datum(DeviceRole::Odometry, 3610.0);
  watched.now = 12.0;
  ASSERT_TRUE(watched.device().age_s);
  EXPECT_NEAR(*watched.device().age_s, 2.0, 1e-9);
}

TEST(RigMonitor, AHeadIsSilentUntilItIsAsked) {
  Watched watched;
  watched.monitor.add(DeviceRole::Head);
  watched.monitor.setState(DeviceRole::Head, DeviceState::Ready, "");
  watched.monitor.datum(DeviceRole::Head, 0.0);
  watched.now = 100.0;
  EXPECT_EQ(watched.device().state, DeviceState::Ready);
}

TEST(RigMonitor, CountsWhatWasRefusedByReasonWithinBounds) {
  RigMonitor monitor;
  monitor.refused("scan late");
  monitor.refused("scan late", "by 3 s");
  for (int i = 0; i < 1000; ++i) monitor.refused("reason " + std::to_string(i));
  const RigStatus status = monitor.status();
  EXPECT_EQ(status.refused.at("scan late"), 2);
  EXPECT_LE(status.refused.size(), 64U);
  EXPECT_EQ(status.last_refusal, "reason 999");
}

}  // namespace
}  // namespace handmap
