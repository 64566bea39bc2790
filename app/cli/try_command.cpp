#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/qt_core.h"
#include "core/base/error.h"
#include "drivers/connected/connected_devices.h"
#include "drivers/live/rig_host.h"

namespace handmap {

namespace {

constexpr auto kLook = std::chrono::milliseconds(50);

struct TryArguments {
  std::string rig;
  double for_s = 10.0;
};

/// What is to be told of a device when the time is over.
struct Tried {
  DeviceStatus last;
  std::optional<double> first_s;  ///< of the first datum, since the opening
};

std::string lineOf(const Tried& tried, double for_s) {
  const DeviceStatus& device = tried.last;
  const std::string detail = device.detail.empty() ? "" : ": " + device.detail;
  const std::string head = fmt::format("{:<9} {:<10}", nameOf(device.role), nameOf(device.state));
  if (!tried.first_s) return fmt::format("{} no data in {:.0f} s{}\n", head, for_s, detail);
  return fmt::format("{} first data after {:.1f} s, {:.1f} a second, {} in all{}\n", head,
                     *tried.first_s, device.rate_hz, device.count, detail);
}

/// The head waits to be told where to look: it gives nothing by itself.
bool works(const Tried& tried) {
  const bool ready = tried.last.state == DeviceState::Ready;
  return tried.last.role == DeviceRole::Head ? ready : ready && tried.first_s;
}

class Trial {
 public:
  Trial(const Rig& rig, const Interrupt& interrupt, double for_s) {
    std::jthread host([this, &rig] { drive(rig); });
    const double begin = monitor_->now();
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    while (monitor_->now() - begin < for_s && !interrupt.requested() && !ended_) {
      look(monitor_->now() - begin);
      never.wait_for(lock, interrupt.token(), kLook, [] { return false; });
    }
    look(monitor_->now() - begin);
    refused_ = monitor_->status().refused;
    monitor_->end();
  }

  const std::map<DeviceRole, Tried>& devices() const { return devices_; }
  const std::map<std::string, long>& refused() const { return refused_; }
  const std::optional<Error>& error() const { return error_; }

 private:
  void drive(const Rig& rig) {
    try {
      RigHost host(rig, connectedDevices(), monitor_);
      while (host.next({})) monitor_->given();
    } catch (const Error& error) {
      error_ = error;
    }
    ended_ = true;
  }

  void look(double elapsed_s) {
    for (const DeviceStatus& device : monitor_->status().devices) {
      Tried& tried = devices_[device.role];
      tried.last = device;
      if (device.count > 0 && !tried.first_s) tried.first_s = elapsed_s;
    }
  }

  std::shared_ptr<RigMonitor> monitor_ = std::make_shared<RigMonitor>();
  std::map<DeviceRole, Tried> devices_;
  std::map<std::string, long> refused_;
  std::optional<Error> error_;
  std::atomic<bool> ended_ = false;
};

int tryRig(const TryArguments& arguments) {
  const Rig rig = readRig(arguments.rig);
  const auto application = qtCore();
  const Interrupt interrupt;
  const Trial trial(rig, interrupt, arguments.for_s);
  if (trial.error()) throw Error(*trial.error());
  int silent = 0;
  for (const auto& [role, tried] : trial.devices()) {
    fmt::print("{}", lineOf(tried, arguments.for_s));
    silent += works(tried) ? 0 : 1;
  }
  for (const auto& [reason, count] : trial.refused()) {
    fmt::print("not used, {} times: {}\n", count, reason);
  }
  return silent == 0 ? 0 : static_cast<int>(ErrorCode::RunFailed);
}

}  // namespace

void addTryCommand(CLI::App& app, ChosenCommand& chosen) {
  const auto arguments = std::make_shared<TryArguments>();
  CLI::App* command = app.add_subcommand("try", "Tell what each device of a robot gives");
  command->callback([&chosen, arguments] { chosen = [arguments] { return tryRig(*arguments); }; });
  command->add_option("rig", arguments->rig, "The robot (required)")
      ->required()
      ->option_text("FILE.json");
  addNumber(*command, "--for", arguments->for_s, 1.0, 3600.0, "Seconds to look");
}

}  // namespace handmap
