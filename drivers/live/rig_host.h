// The thread in which the devices of a rig live, with an event loop.
#pragma once

#include <atomic>
#include <functional>
#include <future>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/rig/rig_monitor.h"
#include "drivers/live/inbox.h"
#include "drivers/live/rig_devices.h"

class QEventLoop;

namespace handmap {

/// Needs a QCoreApplication in the process, not its event loop.
class RigHost {
 public:
  /// The devices are opened; that they are there is told by the monitor. Throws what `make` throws.
  RigHost(const Rig& rig, MakeDevices make, std::shared_ptr<RigMonitor> monitor);
  /// Waits until the devices are at rest and closed: some tenths of a second.
  ~RigHost();
  RigHost(const RigHost&) = delete;
  RigHost& operator=(const RigHost&) = delete;

  /// The newest observation, not rectified; waits for it. nullopt when `stop` was requested, or
  /// when the person has ended the drive (RigMonitor::end(); the devices are then being closed).
  std::optional<Observation> next(const std::stop_token& stop);
  /// The rig measures nothing farther, by the word of its scanner; infinite before the first
  /// observation, and where the scanner says nothing.
  double reach_m() const { return reach_m_; }
  /// As the camera describes itself; nullptr before that, and where it never does.
  std::shared_ptr<const Rectifier> rectifier();

 private:
  class Hosting;
  void end();
  void describe(const std::shared_ptr<const Rectifier>& rectifier);
  void turn(QEventLoop& loop);
  void work(const Rig& rig, const MakeDevices& make, std::promise<void> opened);

  std::shared_ptr<RigMonitor> monitor_;
  Inbox inbox_;
  std::atomic<double> reach_m_ = std::numeric_limits<double>::infinity();
  std::mutex mutex_;
  std::shared_ptr<const Rectifier> rectifier_;  ///< under mutex_
  QEventLoop* loop_ = nullptr;                  ///< while it turns; under mutex_
  std::optional<std::stop_callback<std::function<void()>>> on_end_;
  std::thread thread_;
};

}  // namespace handmap
