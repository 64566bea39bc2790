// A rig file to its observations, through the drivers of real devices: a Hokuyo on a
// pseudo-terminal and a self-made base over TCP, both emulated in this thread.
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <future>
#include <limits>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "drivers/connected/connected_devices.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/live/live_source.h"

namespace handmap {
namespace {

/// A wall straight ahead, 4 m away, as noisy as a laser sees it.
double wallAhead(double angle) {
  static std::minstd_rand random;
  const double ahead_m = 4.0 + std::uniform_real_distribution(-0.01, 0.01)(random);
  return std::cos(angle) > 0.2 ? ahead_m / std::cos(angle)
                               : std::numeric_limits<double>::infinity();
}

struct WiredRig {
  WiredRig()
      : laser(EmulatedPort::Kind::PseudoTerminal, wallAhead),
        wheels(
            EmulatedPort::Kind::Tcp,
            [](double time_s) {
              return Pose2{0.5 * time_s, 0.0, 0.0};
            },
            OdometryEmulator::Form::Fields) {
    job.rig = parseRig(fmt::format(R"({{"format": "handmap-rig", "version": 1, "name": "wired",
        "scanner": {{"kind": "hokuyo", "port": "{}", "mount": {{"x_m": 0.5, "z_m": 0.4}}}},
        "odometry": {{"kind": "lines", "port": "{}"}}}})",
                                   laser.port().address(), wheels.port().address()),
                       "rig.json", "/");
    job.make = connectedDevices();
    job.monitor = std::make_shared<RigMonitor>();
  }

  /// Works in another thread, while the emulators here have their events; false: not within 40 s.
  bool during(const std::function<void()>& work) const {
    auto done = std::async(std::launch::async, work);
    QElapsedTimer timer;
    timer.start();
    const auto is_done = [&done] {
      return done.wait_for(std::chrono::milliseconds(1)) == std::future_status::ready;
    };
    while (!is_done() && timer.elapsed() < 40'000) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    }
    const bool in_time = is_done();
    job.monitor->end();
    while (!is_done()) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    done.get();
    return in_time;
  }

  HokuyoEmulator laser;
  OdometryEmulator wheels;
  LiveJob job;
};

TEST(WiredRig, GivesScansWithTheirPoses) {
  WiredRig rig;
  std::vector<Observation> taken;
  EXPECT_TRUE(rig.during([&] {
    const auto source = openLive(rig.job, {});
    for (int i = 0; source && i < 10; ++i) {
      if (auto observation = source->next()) taken.push_back(std::move(*observation));
    }
  }));
  ASSERT_EQ(taken.size(), 10U);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    ASSERT_FALSE(taken[i].views.at(0).points->empty());
    for (const RangePoint& point : *taken[i].views[0].points) {
      if (!isMeasured(point)) continue;
      EXPECT_NEAR(point.x, 4.5F, 0.1F);  // 4 m before the scanner, which is 0.5 m ahead
      EXPECT_NEAR(point.z, 0.4F, 1e-5F);
    }
    if (i == 0) continue;
    const double dt = taken[i].time_s - taken[i - 1].time_s;
    EXPECT_NEAR(taken[i].odometry.x - taken[i - 1].odometry.x, 0.5 * dt, 0.05 + 0.2 * dt);
  }
}

TEST(WiredRig, LivesWithAScannerThatIsPulledAndPutBack) {
  WiredRig rig;
  std::atomic<int> count = 0;
  std::atomic<bool> lost = false;
  std::atomic<int> after = 0;
  const auto scanner_state = [&rig] {
    for (const DeviceStatus& device : rig.job.monitor->status().devices) {
      if (device.role == DeviceRole::Scanner) return device.state;
    }
    return DeviceState::Closed;
  };
  // The cable is the business of this thread.
  QTimer cable;
  QObject::connect(&cable, &QTimer::timeout, &cable, [&] {
    if (count >= 5 && !lost && rig.laser.port().isPlugged()) rig.laser.port().unplug();
    const DeviceState state = scanner_state();
    const bool gone = state == DeviceState::Lost || state == DeviceState::Connecting;
    if (!rig.laser.port().isPlugged() && gone) {
      lost = true;
      rig.laser.port().plug();
    }
  });
  cable.start(50);
  EXPECT_TRUE(rig.during([&] {
    const auto source = openLive(rig.job, {});
    while (source && after < 5) {
      if (!source->next()) break;
      ++count;
      if (lost) ++after;
    }
  }));
  EXPECT_TRUE(lost);
  EXPECT_GE(after, 5);
}

TEST(WiredRig, AnAddressThatIsNoneIsRefused) {
  WiredRig rig;
  rig.job.rig.scanner->port = "tcp://nowhere:0";
  EXPECT_THROW(openLive(rig.job, {}), std::exception);
}

}  // namespace
}  // namespace handmap
