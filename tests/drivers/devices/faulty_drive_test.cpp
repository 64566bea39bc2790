// Each device of a rig in a drive, each fault after the other: what is said, that the drive goes on
// afterwards, and that its recording replays to what was lived, bit by bit.
#include <QTimer>
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <random>
#include <thread>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/recording/validation.h"
#include "drivers/connected/connected_devices.h"
#include "drivers/emulators/foxglove_bridge_emulator.h"
#include "drivers/emulators/hokuyo_emulator.h"
#include "drivers/emulators/odometry_emulator.h"
#include "drivers/emulators/ros_emulated_messages.h"
#include "drivers/emulators/rosbridge_emulator.h"
#include "drivers/emulators/rplidar_emulator.h"
#include "drivers/live/live_source.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/drivers/devices/waiting.h"

namespace handmap {
namespace {

constexpr int kUnsaid_ms = 500;  // so long a fault lasts of which nothing is said
constexpr int kWhole = 3;        // so many observations are a drive that goes on

struct Fault {
  std::string name;
  std::function<void()> begin;
  std::function<void()> end;
  std::string said;  ///< part of it; empty: nothing need be said
};

std::string asText(const Observation& observation) {
  std::string text = fmt::format("{} {} {} {}", observation.time_s, observation.odometry.x,
                                 observation.odometry.y, observation.odometry.heading);
  for (const double variance : observation.odometry_variance.reshaped()) {
    text += fmt::format(" {}", variance);
  }
  for (const View& view : observation.views) {
    text += fmt::format("\n{}", view.pan);
    if (!view.points) continue;
    for (const RangePoint& p : *view.points)
      text += fmt::format(" {} {} {} {}", p.x, p.y, p.z, p.w);
  }
  return text;
}

/// All that a rig complains of.
std::string complaintsOf(const RigStatus& status) {
  std::string all;
  for (const DeviceStatus& device : status.devices) {
    if (device.state == DeviceState::Degraded || device.state == DeviceState::Lost) {
      all += fmt::format("{}: {}\n", nameOf(device.role), device.detail);
    }
  }
  for (const auto& [reason, count] : status.refused)
    all += fmt::format("{} times {}\n", count, reason);
  return all;
}

/// The devices work in the thread of the rig, the emulators in this one, the run in a third.
class FaultyDrive : public testing::Test {
 protected:
  void begin(const std::string& rig) {
    job_.rig = parseRig(R"({"format": "handmap-rig", "version": 1, )" + rig + "}", "rig.json", "/");
    job_.make = connectedDevices();
    job_.monitor = std::make_shared<RigMonitor>();
    job_.record = folder_.path() / "drive";
    run_ = std::thread([this] {
      const auto source = openLive(job_, {});
      while (source) {
        const auto observation = source->next();
        if (!observation) break;
        lived_.push_back(asText(*observation));
        ++count_;
      }
    });
  }
  ~FaultyDrive() override { stop(); }

  void walk(const std::vector<Fault>& faults) {
    ASSERT_TRUE(goesOn()) << "from the beginning";
    for (const Fault& fault : faults) {
      fault.begin();
      if (fault.said.empty()) {
        test::pass(kUnsaid_ms);
      } else {
        EXPECT_TRUE(test::waitUntil([&] { return said().find(fault.said) != std::string::npos; }))
            << fault.name << ": " << said();
      }
      EXPECT_EQ(said().find("Unknown error"), std::string::npos) << fault.name << ": " << said();
      fault.end();
      ASSERT_TRUE(goesOn()) << "after " << fault.name << ": " << said();
    }
    stop();
    expectReplaysTheSame();
  }

  std::string said() const { return complaintsOf(job_.monitor->status()); }

  LiveJob job_;

 private:
  bool goesOn() const {
    const int before = count_;
    return test::waitUntil([&] { return count_ >= before + kWhole; });
  }
  void stop() {
    if (!run_.joinable()) return;
    job_.monitor->end();
    run_.join();
  }
  void expectReplaysTheSame() const {
    const Recording recording = openRecording(job_.record);
    EXPECT_TRUE(problemsOf(recording).empty());
    std::vector<std::string> replayed;
    const auto source = replay(recording, {});
    while (const auto observation = source->next()) replayed.push_back(asText(*observation));
    ASSERT_EQ(replayed.size(), lived_.size());
    for (std::size_t i = 0; i < lived_.size(); ++i) ASSERT_EQ(replayed[i], lived_[i]) << i;
  }

  test::TemporaryFolder folder_;
  std::thread run_;
  std::vector<std::string> lived_;
  std::atomic<int> count_ = 0;
};

/// A room that a robot crosses, as noisy as a laser sees it.
double room(double angle) {
  static std::minstd_rand random;
  const double range_m = 4.0 + std::cos(3.0 * angle);
  return range_m + std::uniform_real_distribution(-0.01, 0.01)(random);
}

Pose2 ahead(double time_s) { return {0.5 * time_s, 0.0, 0.0}; }

std::string noise(std::size_t bytes) {
  std::minstd_rand random(5);
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(random() % 256);
  return text;
}

/// What can happen to any device on a wire. `gone`, `silent`: what is said of it then.
template <typename Emulator>
std::vector<Fault> faultsOnWire(Emulator& device, const std::string& gone,
                                const std::string& silent) {
  EmulatedPort& port = device.port();
  const auto nothing = [] {};
  const auto wire = [&port](double dropped, double doubled, int delay_ms) {
    return [=, &port] { port.setFaults({dropped, doubled, delay_ms}); };
  };
  return {
      {"gone", [&port] { port.unplug(); }, [&port] { port.plug(); }, gone},
      {"silent", [&device] { device.setDead(true); }, [&device] { device.setDead(false); }, silent},
      {"noise", [&port] { port.write(noise(3000)); }, nothing, ""},
      {"lost bytes", wire(0.002, 0.0, 0), wire(0.0, 0.0, 0), ""},
      {"doubled bytes", wire(0.0, 0.002, 0), wire(0.0, 0.0, 0), ""},
      {"slow", wire(0.0, 0.0, 300), wire(0.0, 0.0, 0), ""}};
}

void add(std::vector<Fault>& faults, std::vector<Fault> more) {
  std::ranges::move(more, std::back_inserter(faults));
}

/// `jump`: sets the clock of the device on by so many hours.
std::vector<Fault> clockFaults(const std::function<void(int)>& jump, const std::string& said) {
  const auto nothing = [] {};
  return {{"clock an hour on", [jump] { jump(1); }, nothing, said},
          {"clock an hour back", [jump] { jump(-1); }, nothing, said}};
}

TEST_F(FaultyDrive, LaserOverScipAndWheels) {
  HokuyoEmulator laser(EmulatedPort::Kind::PseudoTerminal, room);
  OdometryEmulator wheels(EmulatedPort::Kind::Tcp, ahead,
                          OdometryEmulator::Form::FieldsWithChecksum);
  begin(fmt::format(R"("scanner": {{"kind": "hokuyo", "port": "{}"}},
        "odometry": {{"kind": "lines", "port": "{}"}})",
                    laser.port().address(), wheels.port().address()));
  std::vector<Fault> faults = faultsOnWire(laser, "scanner: ", "scanner: ");
  add(faults, clockFaults([&](int hours) { laser.jumpClock(3'600'000LL * hours); }, ""));
  add(faults, faultsOnWire(wheels, "odometry: ", "odometry: "));
  add(faults, clockFaults([&](int hours) { wheels.jumpClock(3600.0 * hours); }, "clock"));
  faults.push_back({"lines cut off",
                    [&wheels] { wheels.say("odom 1.0 2.\n12 1e400 0 0\n{\"x\":"); },
                    [&wheels] { wheels.say("\n"); }, ""});
  walk(faults);
}

TEST_F(FaultyDrive, RplidarAndWheels) {
  RplidarEmulator laser(EmulatedPort::Kind::PseudoTerminal, room,
                        RplidarEmulator::Express::Capsules);
  OdometryEmulator wheels(EmulatedPort::Kind::PseudoTerminal, ahead, OdometryEmulator::Form::Json);
  begin(fmt::format(R"("scanner": {{"kind": "rplidar", "port": "{}"}},
      "odometry": {{"kind": "lines", "port": "{}"}})",
                    laser.port().address(), wheels.port().address()));
  std::vector<Fault> faults = faultsOnWire(laser, "scanner: ", "scanner: ");
  add(faults, faultsOnWire(wheels, "odometry: ", "odometry: "));
  walk(faults);
}

/// A robot that publishes on its own clock, and what can happen on the way.
template <typename Ros>
struct RosRobot {
  explicit RosRobot(RosVersion version) : version(version) {
    QObject::connect(&timer, &QTimer::timeout, &timer, [this] { tick(); });
    if constexpr (std::is_same_v<Ros, FoxgloveBridgeEmulator>) {
      ros.offer("/scan", "sensor_msgs/msg/LaserScan");
      ros.offer("/odom", "nav_msgs/msg/Odometry");
    }
    clock.start();
    timer.start(20);
  }

  std::string rig() const {
    const std::string url = ros.url().toString().toStdString();
    return fmt::format(R"("ros": {}, "scanner": {{"kind": "ros", "port": "{}", "topic": "/scan"}},
        "odometry": {{"kind": "ros", "port": "{}", "topic": "/odom"}})",
                       version == RosVersion::Ros1 ? 1 : 2, url, url);
  }

  void tick() {
    const double since_s = 1e-3 * static_cast<double>(clock.elapsed());
    const double stamp_s = 1.5e9 + since_s + clock_off_s;
    if (!is_odometry_mute) send("/odom", emulated::odometry(stamp_s, ahead(since_s), version));
    if (++ticks % 2 == 0 && !is_scan_mute) {
      std::vector<float> ranges;
      for (int i = 0; i < 180; ++i) ranges.push_back(static_cast<float>(room(0.035 * i - kPi)));
      send("/scan", emulated::laserScan(stamp_s, ranges, version));
    }
  }
  void send(const QString& topic, const QCborMap& message) {
    if (delay_ms == 0) return ros.publish(topic, message);
    QTimer::singleShot(delay_ms, &timer, [this, topic, message] { ros.publish(topic, message); });
  }

  std::vector<Fault> faults() {
    const auto nothing = [] {};
    const auto mute = [](bool& is_mute, bool on) { return [&is_mute, on] { is_mute = on; }; };
    const QByteArray some = QByteArray::fromStdString(noise(2000));
    std::vector<Fault> all{
        {"gone", [this] { ros.unplug(); }, [this] { ros.plug(); }, "Connection refused"},
        {"scan silent", mute(is_scan_mute, true), mute(is_scan_mute, false),
         "nothing comes of /scan any more"},
        {"odometry silent", mute(is_odometry_mute, true), mute(is_odometry_mute, false),
         "nothing comes of /odom any more"},
        {"noise",
         [this, some] {
           ros.sendRaw(some, true);
           ros.sendRaw("{\"op\": \"publish\", \"topic\": \"/scan\", \"msg\": {\"ran", false);
           ros.sendRaw("{\"op\": \"publish\", \"topic\": \"/odom\", \"msg\": {\"pose\": 7}}",
                       false);
         },
         nothing, ""},
        {"slow", [this] { delay_ms = 300; }, [this] { delay_ms = 0; }, ""}};
    add(all, clockFaults([this](int hours) { clock_off_s += 3600.0 * hours; }, ""));
    return all;
  }

  Ros ros;
  RosVersion version;
  QTimer timer;
  QElapsedTimer clock;
  double clock_off_s = 0.0;
  bool is_scan_mute = false;
  bool is_odometry_mute = false;
  int delay_ms = 0;
  int ticks = 0;
};

TEST_F(FaultyDrive, RobotBehindARosbridge) {
  RosRobot<RosbridgeEmulator> robot(RosVersion::Ros1);
  begin(robot.rig());
  walk(robot.faults());
}

TEST_F(FaultyDrive, RobotBehindAFoxgloveBridge) {
  RosRobot<FoxgloveBridgeEmulator> robot(RosVersion::Ros2);
  begin(robot.rig());
  std::vector<Fault> faults = robot.faults();
  const auto nothing_comes = [&robot](bool on) {
    robot.is_scan_mute = on;
    if (on) return robot.ros.withdraw("/scan");
    robot.ros.offer("/scan", "sensor_msgs/msg/LaserScan");
  };
  faults.push_back({"topic withdrawn", [=] { nothing_comes(true); }, [=] { nothing_comes(false); },
                    "scanner: "});
  walk(faults);
}

}  // namespace
}  // namespace handmap
