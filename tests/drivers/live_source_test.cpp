#include "drivers/live/live_source.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/recording/recording.h"
#include "core/session/run_session.h"
#include "core/trajectory/odometry_choice.h"
#include "drivers/virtual/virtual_rig.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

VirtualDrive drive(const std::string& faults = {}) {
  VirtualDrive drive{twoRowWorld(3), 3};
  drive.speed_m_s = 10.0;
  drive.step_m = 0.5;  // 20 Hz
  drive.faults = parseFaults(faults);
  return drive;
}

LiveJob job(const VirtualDrive& drive, const fs::path& record = {}) {
  return {virtualRig(drive), virtualDevices(drive), std::make_shared<RigMonitor>(), record};
}

/// The next observation that can be used.
Observation take(ObservationSource& source) {
  auto observation = source.next();
  EXPECT_TRUE(observation);
  return observation ? *observation : Observation{};
}

/// Takes observations until the rig's clock says so.
std::vector<Observation> takeUntil(ObservationSource& source, const RigMonitor& monitor,
                                   double time_s) {
  std::vector<Observation> taken;
  while (monitor.now() < time_s) taken.push_back(take(source));
  return taken;
}

const DeviceStatus& statusOf(const RigStatus& status, DeviceRole role) {
  for (const DeviceStatus& device : status.devices) {
    if (device.role == role) return device;
  }
  throw std::logic_error("no such device");
}

TEST(LiveSource, HasNoEndButThatThePersonEndsTheDrive) {
  const LiveJob live = job(drive());
  const auto source = openLive(live, {});
  ASSERT_TRUE(source);
  EXPECT_EQ(source->info().observations, 0);
  int frame = -1;
  double time_s = -1.0;
  for (int i = 0; i < 5; ++i) {
    const Observation observation = take(*source);
    EXPECT_GT(observation.frame, frame);
    EXPECT_GT(observation.time_s, time_s);
    EXPECT_FALSE(observation.views.at(0).points->empty());
    frame = observation.frame;
    time_s = observation.time_s;
  }
  live.monitor->end();
  while (source->next()) {
  }
  EXPECT_FALSE(source->next());
  EXPECT_GE(live.monitor->status().given, 5);
}

// If nobody woke them, the following two would run into their time limits.
TEST(LiveSource, AStopWakesWhoWaitsForTheFirstObservation) {
  std::stop_source stop;
  const std::jthread stopper([&stop] {
    std::this_thread::sleep_for(100ms);
    stop.request_stop();
  });
  EXPECT_FALSE(openLive(job(drive("scanner:unplug@0+1000")), stop.get_token()));
}

TEST(LiveSource, TheEndOfTheDriveWakesWhoWaits) {
  const LiveJob live = job(drive("scanner:unplug@0+1000"));
  const std::jthread stopper([&live] {
    std::this_thread::sleep_for(100ms);
    live.monitor->end();
  });
  EXPECT_FALSE(openLive(live, {}));
}

TEST(LiveSource, ASlowRunGetsTheNewestAndTheWayOfThoseThatItMissed) {
  const VirtualDrive way = drive();
  const LiveJob live = job(way);
  const auto source = openLive(live, {});
  const Observation first = take(*source);
  std::this_thread::sleep_for(600ms);
  const Observation second = take(*source);
  EXPECT_GT(second.frame, first.frame + 5);
  EXPECT_GT(live.monitor->status().passed_over, 4);
  // 10 m/s; the wheels are off by some percent.
  const double driven = (second.odometry.position() - first.odometry.position()).norm();
  EXPECT_NEAR(driven, way.speed_m_s * (second.time_s - first.time_s), 0.2 * driven);
  EXPECT_LT(live.monitor->now() - second.time_s, 2.0) << "the newest, not the oldest";
}

/// Whose devices are told what to say.
template <typename Sensor>
struct Spoken : Sensor {
  std::function<void()> on_open = [] {};
  void open() override { on_open(); }
  void close() override {}
};

TEST(LiveSource, ScansThatWaitedForOneOdometryAreAllTaken) {
  LiveJob live = job(drive());
  live.monitor = std::make_shared<RigMonitor>([] { return 100.0; });
  live.make = [](const Rig&, RigMonitor&) {
    auto odometry = std::make_unique<Spoken<OdometrySensor>>();
    auto scanner = std::make_unique<Spoken<RangeSensor>>();
    scanner->on_open = [odometry = odometry.get(), scanner = scanner.get()] {
      Q_EMIT odometry->moved(98.0, {});
      Q_EMIT odometry->moved(99.0, {});
      for (int i = 1; i < 10; ++i) Q_EMIT scanner->scanned(99.0 + 0.1 * i, {{1, 0, 0, 1}});
      Q_EMIT odometry->moved(100.0, {1.0, 0.0, 0.0});
    };
    RigDevices devices;
    devices.odometry = std::move(odometry);
    devices.scanner = std::move(scanner);
    return devices;
  };
  const auto source = openLive(live, {});
  for (int i = 1; i < 10; ++i) EXPECT_NEAR(take(*source).odometry.x, 0.1 * i, 1e-9);
  EXPECT_EQ(live.monitor->status().passed_over, 0);
}

TEST(LiveSource, NothingIsMeasuredFartherThanTheScannerReaches) {
  for (const auto& [reach_m, limit_m] : {std::pair(12.0, 12.0), std::pair(1e4, 40.0)}) {
    LiveJob live = job(drive());
    live.rig.range_limit_m = 40.0;
    live.rig.odometry.kind = OdometryRigKind::None;
    live.make = [reach_m = reach_m](const Rig&, RigMonitor& monitor) {
      auto scanner = std::make_unique<Spoken<RangeSensor>>();
      scanner->on_open = [&monitor, reach_m, scanner = scanner.get()] {
        Q_EMIT scanner->reaches(reach_m);
        Q_EMIT scanner->scanned(monitor.now(), {{1, 0, 0, 1}});
      };
      RigDevices devices;
      devices.scanner = std::move(scanner);
      return devices;
    };
    EXPECT_EQ(openLive(live, {})->info().range_limit_m, limit_m);
  }
}

TEST(LiveSource, TellsStateAgeAndRateOfEachDevice) {
  const LiveJob live = job(drive());
  const auto source = openLive(live, {});
  takeUntil(*source, *live.monitor, 3.0);
  const RigStatus status = live.monitor->status();
  ASSERT_EQ(status.devices.size(), 2U);
  for (const DeviceRole role : {DeviceRole::Odometry, DeviceRole::Scanner}) {
    const DeviceStatus& device = statusOf(status, role);
    EXPECT_EQ(device.state, DeviceState::Ready) << device.detail;
    ASSERT_TRUE(device.age_s);
    EXPECT_GT(device.rate_hz, 1.0);
    EXPECT_LT(device.rate_hz, 40.0);
    EXPECT_GT(device.count, 5);
  }
}

TEST(LiveSource, AScannerThatIsUnpluggedAndPluggedInAgainIsSaidAndLivedWith) {
  const LiveJob live = job(drive("scanner:unplug@1+1.5"));
  const auto source = openLive(live, {});
  takeUntil(*source, *live.monitor, 0.8);
  std::this_thread::sleep_for(700ms);
  const RigStatus gone = live.monitor->status();
  EXPECT_EQ(statusOf(gone, DeviceRole::Scanner).state, DeviceState::Lost);
  EXPECT_EQ(statusOf(gone, DeviceRole::Scanner).detail, "unplugged");
  EXPECT_EQ(statusOf(gone, DeviceRole::Odometry).state, DeviceState::Ready);
  const auto after = takeUntil(*source, *live.monitor, 3.5);
  EXPECT_GT(after.back().time_s, 2.5);
  EXPECT_EQ(statusOf(live.monitor->status(), DeviceRole::Scanner).state, DeviceState::Ready);
}

struct FaultCase {
  const char* faults;
  const char* refused;  ///< what is counted
};
void PrintTo(const FaultCase& fault, std::ostream* out) { *out << fault.faults; }

/// How far the robot moved, and how sure it was of where it is, as far as a run tells.
struct Lived {
  double sigma(double from_s, double to_s) const {
    double most = 0.0;
    for (const FrameReport& report : reports) {
      if (report.time_s < from_s || report.time_s > to_s) continue;
      most = std::max(most, std::hypot(report.pose_sigma[0], report.pose_sigma[1]));
    }
    return most;
  }
  std::vector<FrameReport> reports;
  double moved_blind_m = 0.0;
};

/// Three seconds without a scan from the second second on.
Lived livedWithoutScanner(OdometryRigKind odometry) {
  VirtualDrive driven = drive("scanner:unplug@2+3");
  driven.speed_m_s = 1.4;
  driven.step_m = 0.1;
  LiveJob live = job(driven);
  live.rig.odometry.kind = odometry;
  auto source = openLive(live, {});
  RunSettings settings;
  settings.slam.slam_particles = 5;
  Map drawing = driven.world.map;
  RunSession session(drawing, std::move(source), settings);
  Lived lived;
  while (live.monitor->now() < 7.0) {
    const auto snapshot = session.step();
    if (!snapshot) break;
    lived.reports.push_back(snapshot->report);
  }
  live.monitor->end();
  const auto at = [&](double time_s) {
    return std::find_if(lived.reports.begin(), lived.reports.end(),
                        [=](const FrameReport& report) { return report.time_s >= time_s; })
        ->pose.position();
  };
  lived.moved_blind_m = (at(4.7) - at(3.0)).norm();
  return lived;
}

TEST(LiveSource, ADeadScannerLeavesTheWayToTheWheelsAndTheRobotLessSure) {
  const Lived lived = livedWithoutScanner(OdometryRigKind::Virtual);
  EXPECT_NEAR(lived.moved_blind_m, 1.7 * 1.4, 0.5);
  EXPECT_GT(lived.sigma(4.0, 5.0), lived.sigma(1.5, 2.0));
}

TEST(LiveSource, ADeadScannerWithoutWheelsIsLostUntilItIsRecognised) {
  const Lived lived = livedWithoutScanner(OdometryRigKind::Scan);
  EXPECT_LT(lived.sigma(1.5, 2.0), 1.5);
  EXPECT_GT(lived.sigma(4.0, 5.0), 3.0);
  // A street looks the same along itself: it is taken for found only where the scans say so.
  EXPECT_FALSE(lived.reports.empty());
}

class FaultyRig : public testing::TestWithParam<FaultCase> {};

TEST_P(FaultyRig, CountsWhatCannotBeUsedAndRecovers) {
  const LiveJob live = job(drive(GetParam().faults));
  const auto source = openLive(live, {});
  ASSERT_TRUE(source);
  const auto taken = takeUntil(*source, *live.monitor, 5.5);
  RigStatus status = live.monitor->status();
  EXPECT_GT(status.refused[GetParam().refused], 0) << status.last_refusal;
  EXPECT_GT(taken.back().time_s, 4.5) << "it goes on";
  for (std::size_t i = 1; i < taken.size(); ++i) {
    ASSERT_GT(taken[i].time_s, taken[i - 1].time_s);
    EXPECT_LT((taken[i].odometry.position() - taken[i - 1].odometry.position()).norm(),
              15.0 * (taken[i].time_s - taken[i - 1].time_s) + 1.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, FaultyRig,
    testing::Values(FaultCase{"odometry:unplug@1+1.5", "no odometry at the time of an observation"},
                    FaultCase{"odometry:late@1+0.7", "odometry late"},
                    FaultCase{"odometry:clock@1+1", "odometry stamped in the future"},
                    FaultCase{"scanner:late@1+0.7", "scan late"},
                    FaultCase{"scanner:clock@1+1", "scan stamped in the future"}));

/// Ten seconds of a live run; the map and the way that came out of it.
struct Outcome {
  std::string map;
  std::string way;
  std::size_t frames = 0;
};

Outcome outcomeOf(RunSession& session, const std::function<void()>& after_step) {
  while (session.step()) after_step();
  return {formatMap(session.refinedMap()), formatTum(session.trajectory()),
          session.frames().size()};
}

void expectLiveEqualsReplay(OdometryRigKind odometry, const std::string& faults = {}) {
  const test::TemporaryFolder folder;
  const VirtualDrive way = drive(faults);
  LiveJob live = job(way, folder.path() / "run");
  live.rig.odometry.kind = odometry;
  Map sketch = perturbed(way.world.map, 3.0, 5);
  RunSettings settings;
  settings.slam.slam_particles = 20;
  settings.threads = 2;
  RunSession session(sketch, openLive(live, {}), settings);
  const Outcome lived = outcomeOf(session, [&live] {
    if (live.monitor->now() > 6.0) live.monitor->end();
  });
  const RecordingStatus recording = live.monitor->status().recording;
  EXPECT_EQ(recording.error, "");
  EXPECT_EQ(recording.observations, static_cast<int>(lived.frames));
  EXPECT_GT(lived.frames, 5U);

  RunSession again(
      sketch,
      replayWithOdometry(openRecording(folder.path() / "run"), {}, OdometryKind::Recorded).source,
      settings);
  const Outcome replayed = outcomeOf(again, [] {});
  EXPECT_EQ(replayed.frames, lived.frames);
  EXPECT_EQ(replayed.way, lived.way);
  EXPECT_EQ(replayed.map, lived.map);
}

TEST(LiveSource, LiveEqualsReplayWithWheels) { expectLiveEqualsReplay(OdometryRigKind::Virtual); }

TEST(LiveSource, LiveEqualsReplayWithScansAlone) { expectLiveEqualsReplay(OdometryRigKind::Scan); }

/// Nothing tells how far it went, live as little as in the recording of it.
TEST(LiveSource, WithoutWheelsBetweenTwoLongWallsTheWayIsAGuess) {
  const test::TemporaryFolder folder;
  VirtualDrive way = drive();
  way.world = {};
  for (const double y : {-6.0, 6.0}) {
    Building wall;
    wall.id = y < 0.0 ? "S" : "N";
    wall.shape = Rectangle{{0.0, y}, 600.0, 2.0, 0.0};
    way.world.map.buildings.push_back(wall);
  }
  way.world.map.start = Pose2{};
  way.world.map.route = {{0.0, 0.0}, {100.0, 0.0}};
  LiveJob live = job(way, folder.path() / "run");
  live.rig.odometry.kind = OdometryRigKind::Scan;
  std::vector<Observation> lived;
  {
    const auto source = openLive(live, {});
    lived = takeUntil(*source, *live.monitor, 5.0);
  }
  EXPECT_GT(lived.back().odometry_variance(0, 0), 1.0);
  EXPECT_LT(lived.back().odometry_variance(1, 1), 0.01) << "the walls hold it aside";
  const auto replayed =
      replayWithOdometry(openRecording(folder.path() / "run"), {}, OdometryKind::Recorded).source;
  for (const Observation& observation : lived) {
    const Observation again = take(*replayed);
    ASSERT_EQ(again.odometry, observation.odometry);
    ASSERT_EQ(again.odometry_variance, observation.odometry_variance);
  }
}

TEST(LiveSource, LiveEqualsReplayUnderEveryFaultOfTheScanner) {
  expectLiveEqualsReplay(OdometryRigKind::Virtual,
                         "scanner:drop@0.5+0.5,scanner:unplug@1.2+1.5,scanner:late@3+0.4,"
                         "scanner:freeze@3.6+0.5,scanner:clock@4.3+0.5");
}

TEST(LiveSource, LiveEqualsReplayUnderEveryFaultOfTheOdometry) {
  expectLiveEqualsReplay(OdometryRigKind::Virtual,
                         "odometry:drop@0.5+0.5,odometry:unplug@1.2+1.5,odometry:late@3+0.4,"
                         "odometry:freeze@3.6+0.5,odometry:clock@4.3+0.5");
}

TEST(LiveSource, ADiskThatIsGoneEndsTheRecordingNotTheRun) {
  const test::TemporaryFolder folder;
  const fs::path record = folder.path() / "run";
  const LiveJob live = job(drive(), record);
  const auto source = openLive(live, {});
  for (int i = 0; i < 3; ++i) take(*source);
  fs::remove_all(record);
  for (int i = 0; i < 3; ++i) take(*source);
  const RecordingStatus recording = live.monitor->status().recording;
  EXPECT_EQ(recording.observations, 3);
  EXPECT_NE(recording.error.find("cannot be written"), std::string::npos) << recording.error;
}

TEST(LiveSource, RefusesAFolderThatIsNotNew) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder.path() / "run" / "something");
  EXPECT_THROW(openLive(job(drive(), folder.path() / "run"), {}), Error);
}

TEST(LiveSource, WhatTheDevicesRefuseIsThrown) {
  LiveJob live = job(drive());
  live.make = [](const Rig&, RigMonitor&) -> RigDevices {
    throw Error(ErrorCode::BadInput, "no such port");
  };
  EXPECT_THROW(openLive(live, {}), Error);
}

TEST(Faults, AreReadFromText) {
  const auto faults = parseFaults("scanner:unplug@10+5,odometry:late@20.5+3");
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faultAt(faults, DeviceRole::Scanner, 12.0), FaultKind::Unplug);
  EXPECT_EQ(faultAt(faults, DeviceRole::Scanner, 15.0), std::nullopt);
  EXPECT_EQ(faultAt(faults, DeviceRole::Odometry, 21.0), FaultKind::Late);
  for (const char* wrong : {"scanner", "scanner:melt@1+1", "wheel:late@1+1", "scanner:late@1",
                            "scanner:late@-1+1", "scanner:late@1+0", "scanner:late@nan+1", ","}) {
    EXPECT_THROW(parseFaults(wrong), Error) << wrong;
  }
}

}  // namespace
}  // namespace handmap
