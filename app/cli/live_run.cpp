#include "app/cli/live_run.h"

#include <QCoreApplication>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <functional>
#include <map>
#include <mutex>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/cli/options.h"
#include "app/cli/qt_core.h"
#include "core/base/error.h"
#include "drivers/connected/connected_devices.h"
#include "drivers/virtual/stereo_rig.h"

namespace handmap {

namespace {

constexpr auto kLook = std::chrono::milliseconds(250);
constexpr double kSilence_s = 8.0;  // scanners need some seconds to spin up
constexpr double kMostSeconds = 1e7;

/// Why there is no observation yet, as far as the devices tell.
std::string whyNothing(const RigStatus& status) {
  std::string why;
  for (const DeviceStatus& device : status.devices) {
    if (device.role > DeviceRole::Camera || device.count > 0) continue;
    why += fmt::format("; {}: no data, {}{}{}", nameOf(device.role), nameOf(device.state),
                       device.detail.empty() ? "" : ": ", device.detail);
  }
  for (const auto& [reason, count] : status.refused) {
    why += fmt::format("; not used, {} times: {}", count, reason);
  }
  if (why.empty()) why = "; all devices send: do scans or images and odometry have the same clock?";
  return "nothing to be seen yet" + why;
}

/// A folder of its own for this drive.
std::filesystem::path recordFolder(const std::filesystem::path& inside) {
  if (inside.empty()) return {};
  return inside / fmt::format("{:%Y%m%d-%H%M%S}", fmt::localtime(std::time(nullptr)));
}

VirtualRigKind kindOf(const LiveArguments& arguments) {
  return arguments.virtual_rig == "camera" ? VirtualRigKind::StereoHead : VirtualRigKind::Laser;
}

VirtualDrive driveThroughDrawing(const Map& drawing, std::uint64_t seed,
                                 const LiveArguments& arguments) {
  VirtualDrive drive;
  drive.world = worldFromMap(perturbed(drawing, drawing.uncertainty.position, seed), seed);
  drive.seed = seed;
  if (kindOf(arguments) == VirtualRigKind::StereoHead) drive.world = furnished(drive.world, seed);
  drive.faults = parseFaults(arguments.faults, kindOf(arguments));
  return drive;
}

/// Without a value CLI11 gives the default, or one of its own.
std::string laserUnlessTold(std::string& kind) {
  if (kind == "camera" || kind == "laser") return {};
  if (!kind.empty() && kind != "true" && kind != "{}") {
    return fmt::format("found {}, expected laser or camera", kind);
  }
  kind = "laser";
  return {};
}

}  // namespace

void addLive(CLI::App& command, LiveArguments& arguments) {
  command.add_option("--rig", arguments.rig, "A live robot in place of a recording")
      ->option_text("FILE.json");
  command
      .add_option("--virtual-rig", arguments.virtual_rig,
                  "A simulated live robot in place of a recording, driving through what the map "
                  "might be in truth: with a laser, or with a stereo camera that looks around at "
                  "each stop")
      ->expected(0, 1)
      ->default_str("laser")
      ->transform(CLI::Validator(laserUnlessTold, ""))
      ->option_text("[laser|camera]");
  command
      .add_option("--faults", arguments.faults,
                  "What goes wrong in the virtual rig, e.g. scanner:unplug@10+5,odometry:late@20+3")
      ->option_text("LIST");
  command.add_option("--record", arguments.record, "Record the live robot into this new folder")
      ->option_text("DIR");
  addNumber(command, "--for", arguments.for_s, 0.1, kMostSeconds,
            "End the live drive after N seconds, as Ctrl-C does");
}

void checkLive(const CLI::App& command, const LiveArguments& arguments, bool recording) {
  const int sources =
      int(recording) + int(!arguments.rig.empty()) + int(!arguments.virtual_rig.empty());
  if (sources != 1) {
    throw Error(ErrorCode::Usage,
                fmt::format("found {} of --recording, --rig and --virtual-rig, expected one",
                            sources == 0 ? "none" : std::to_string(sources)));
  }
  const auto refuse = [&command](const char* option, const char* needs) {
    if (command.count(option) == 0) return;
    throw Error(ErrorCode::Usage, fmt::format("{}: only with {}", option, needs));
  };
  if (recording) {
    for (const char* option : {"--record", "--for"}) refuse(option, "--rig or --virtual-rig");
  } else {
    for (const char* option : {"--from", "--to", "--every", "--source", "--odometry", "--speed"}) {
      refuse(option, "--recording");
    }
  }
  if (arguments.virtual_rig.empty()) refuse("--faults", "--virtual-rig");
  if (!arguments.record.empty()) checkOutputFolder(arguments.record);
}

LiveDrive::LiveDrive(const LiveArguments& arguments, const Map& drawing, std::uint64_t seed)
    : for_s_(arguments.for_s) {
  application_ = qtCore();
  job_.monitor = std::make_shared<RigMonitor>();
  if (!arguments.virtual_rig.empty()) {
    VirtualDrive drive = driveThroughDrawing(drawing, seed, arguments);
    const bool stereo = kindOf(arguments) == VirtualRigKind::StereoHead;
    job_.rig = stereo ? virtualStereoRig() : virtualRig(drive);
    job_.make = stereo ? virtualStereoDevices(std::move(drive)) : virtualDevices(std::move(drive));
  } else {
    job_.rig = readRig(arguments.rig);
    job_.make = connectedDevices();
  }
  job_.record = arguments.record.empty() ? recordFolder(job_.rig.record)
                                         : std::filesystem::path(arguments.record);
}

LiveDrive::~LiveDrive() = default;

std::optional<StampedPose> LiveDrive::takeGivenPose() {
  const std::scoped_lock lock(given_mutex_);
  return std::exchange(given_, std::nullopt);
}

void LiveDrive::tell(const std::shared_ptr<const Snapshot>& snapshot) const {
  if (onlookers_) onlookers_->tell(snapshot);
}

std::unique_ptr<ObservationSource> LiveDrive::open(const Interrupt& interrupt, Progress& progress) {
  onlookers_ = Onlookers::of(job_.rig, job_.monitor, [this](double time_s, const Pose2& pose) {
    const std::scoped_lock lock(given_mutex_);
    given_ = StampedPose{time_s, pose};
  });
  watcher_ = std::jthread([this, &progress, end = interrupt.token()](const std::stop_token& stop) {
    const std::stop_callback on_interrupt(end, [this] { job_.monitor->end(); });
    watch(stop, progress);
  });
  return openLive(job_, {});
}

/// Tells every change of a device once, and ends the drive in time.
void LiveDrive::watch(const std::stop_token& stop, Progress& progress) const {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  std::map<DeviceRole, std::string> told;
  std::string recording_told;
  bool silence_told = false;
  const double begin = job_.monitor->now();
  while (!stop.stop_requested()) {
    const RigStatus status = job_.monitor->status();
    for (const DeviceStatus& device : status.devices) {
      const std::string now = fmt::format("{}: {}{}{}", nameOf(device.role), nameOf(device.state),
                                          device.detail.empty() ? "" : ": ", device.detail);
      const bool same_silence = device.state == DeviceState::Degraded &&
                                told[device.role].starts_with(now.substr(0, now.rfind(" for ")));
      if (told[device.role] == now || same_silence) continue;
      told[device.role] = now;
      progress.message(now);
    }
    if (status.recording.error != recording_told) {
      recording_told = status.recording.error;
      progress.message(fmt::format("the recording has ended, the run goes on: {}", recording_told));
    }
    const bool nothing = status.given == 0 && !status.observation_age_s;
    if (nothing && !silence_told && job_.monitor->now() - begin > kSilence_s) {
      silence_told = true;
      progress.message(whyNothing(status));
    }
    if (for_s_ && job_.monitor->now() - begin >= *for_s_) job_.monitor->end();
    never.wait_for(lock, stop, kLook, [] { return false; });
  }
}

std::string LiveDrive::summary() const {
  const RigStatus status = job_.monitor->status();
  std::string text = fmt::format("{} observations taken, {} passed over for newer ones\n",
                                 status.given, status.passed_over);
  for (const auto& [reason, count] : status.refused) {
    text += fmt::format("not used, {} times: {}\n", count, reason);
  }
  if (!status.recording.folder.empty()) {
    text += fmt::format("recorded: {} observations in {}\n", status.recording.observations,
                        status.recording.folder);
  }
  return text;
}

}  // namespace handmap
