// What each fault of a virtual rig looks like, as a table: fault_table [laser|camera] [FAULT …],
// where FAULT is "odometry:unplug" and so on; all of them without. Takes half a minute to a minute
// for each.
#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <clocale>
#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "core/base/error.h"
#include "drivers/live/live_source.h"
#include "drivers/virtual/stereo_rig.h"

namespace handmap {
namespace {

using namespace std::chrono_literals;

constexpr double kFault_s = 5.0;  // so long it lasts
constexpr double kPatience_s = 90.0;
constexpr double kBefore_s = 0.5;  // when it is asked what is complained of anyway

struct Row {
  std::string said;
  double named_s = -1.0;      ///< after it began; negative: never
  double recovered_s = -1.0;  ///< the next whole observation, after it ended
  double gap_s = 0.0;         ///< the longest between two observations
  double usual_gap_s = 0.0;
};

/// Everything that a rig complains of.
std::vector<std::string> complaints(const RigStatus& status) {
  std::vector<std::string> all;
  for (const DeviceStatus& device : status.devices) {
    if (device.state != DeviceState::Degraded && device.state != DeviceState::Lost) continue;
    const std::size_t end = std::min(device.detail.find(" for "), device.detail.find(": found "));
    const std::string detail = device.detail.substr(0, end);
    all.push_back(fmt::format("{} {}: {}", nameOf(device.role), nameOf(device.state), detail));
  }
  for (const auto& [reason, count] : status.refused) all.push_back(reason);
  return all;
}

class Trial {
 public:
  explicit Trial(LiveJob job) : job_(std::move(job)), taker_([this] { take(); }) {}
  ~Trial() {
    job_.monitor->end();
    taker_.join();
  }

  int count() const { return count_; }
  double longestGap() const { return gap_s_; }
  double last() const { return last_s_; }

 private:
  void take() {
    const auto source = openLive(job_, {});
    while (source) {
      try {
        if (!source->next()) return;
      } catch (const FrameError&) {
        continue;  // told by the monitor
      }
      const double now = job_.monitor->now();
      if (count_ > 0) gap_s_ = std::max(gap_s_.load(), now - last_s_);
      last_s_ = now;
      ++count_;
    }
  }

  LiveJob job_;
  std::atomic<int> count_ = 0;
  std::atomic<double> last_s_ = 0.0;
  std::atomic<double> gap_s_ = 0.0;
  std::thread taker_;
};

VirtualDrive driveOf(VirtualRigKind kind) {
  VirtualDrive drive{twoRowWorld(3), 3};
  if (kind == VirtualRigKind::StereoHead) {
    drive.world = furnished(drive.world, 3);
    drive.speed_m_s = 10.0;  // the stops are what counts
  }
  return drive;
}

Row rowOf(VirtualRigKind kind, DeviceRole role, FaultKind fault) {
  const bool stereo = kind == VirtualRigKind::StereoHead;
  auto monitor = std::make_shared<RigMonitor>();
  VirtualDrive drive = driveOf(kind);
  // When the first look around is over and the second has begun.
  const double begin_s = stereo ? 30.0 : 4.0;
  drive.faults = {{role, fault, begin_s, begin_s + kFault_s}};
  const Rig rig = stereo ? virtualStereoRig() : virtualRig(drive);
  const MakeDevices make = stereo ? virtualStereoDevices(drive) : virtualDevices(drive);
  Trial trial({rig, make, monitor, {}});
  Row row;
  while (monitor->now() < begin_s - kBefore_s) std::this_thread::sleep_for(10ms);
  row.usual_gap_s = trial.longestGap();
  const auto before = complaints(monitor->status());
  const double end_s = begin_s + kFault_s;
  while (monitor->now() < end_s + kPatience_s) {
    const double now = monitor->now();
    for (const std::string& complaint : complaints(monitor->status())) {
      const bool old = std::find(before.begin(), before.end(), complaint) != before.end();
      if (old || row.said.find(complaint) != std::string::npos) continue;
      if (row.named_s < 0.0) row.named_s = std::max(0.0, now - begin_s);
      row.said += (row.said.empty() ? "" : "; ") + complaint;
    }
    if (now > end_s && trial.last() > end_s) break;
    std::this_thread::sleep_for(20ms);
  }
  if (trial.last() > end_s) row.recovered_s = trial.last() - end_s;
  row.gap_s = trial.longestGap();
  return row;
}

std::string seconds(double value) { return value < 0.0 ? "–" : fmt::format("{:.1f} s", value); }

void printTable(VirtualRigKind kind, const std::vector<std::string>& wanted) {
  fmt::print(
      "| fault of {} s | what is said | named after | next observation after its end | longest gap "
      "(before) |\n|---|---|---|---|---|\n",
      kFault_s);
  for (const auto& [role, fault] : possibleFaults(kind)) {
    const std::string name = fmt::format("{}:{}", nameOf(role), nameOf(fault));
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    const Row row = rowOf(kind, role, fault);
    fmt::print("| {} | {} | {} | {} | {} ({}) |\n", name, row.said.empty() ? "nothing" : row.said,
               seconds(row.named_s), seconds(row.recovered_s), seconds(row.gap_s),
               seconds(row.usual_gap_s));
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace handmap

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  std::setlocale(LC_ALL, "C");
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool stereo = !wanted.empty() && wanted.front() == "camera";
  if (!wanted.empty() && (stereo || wanted.front() == "laser")) wanted.erase(wanted.begin());
  try {
    handmap::printTable(
        stereo ? handmap::VirtualRigKind::StereoHead : handmap::VirtualRigKind::Laser, wanted);
  } catch (const handmap::Error& error) {
    fmt::print(stderr, "fault_table: {}\n", error.what());
    return static_cast<int>(error.code());
  }
  return 0;
}
