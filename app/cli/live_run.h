// A live robot on the command line: run --rig and run --virtual-rig.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <CLI/App.hpp>

#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "core/map/map.h"
#include "drivers/live/live_source.h"
#include "drivers/onlookers/onlookers.h"

class QCoreApplication;

namespace handmap {

struct LiveArguments {
  std::string rig;
  std::string virtual_rig;  ///< "laser" or "camera"; empty: none
  std::string faults;
  std::string record;
  std::optional<double> for_s;

  bool any() const { return !rig.empty() || !virtual_rig.empty(); }
};

void addLive(CLI::App& command, LiveArguments& arguments);
/// Throws Usage for options that mean nothing here; `recording`: one was given.
void checkLive(const CLI::App& command, const LiveArguments& arguments, bool recording);

/// One drive: until Ctrl-C, or for so many seconds.
class LiveDrive {
 public:
  /// `seed`: of the world of a virtual rig, which is what `drawing` might be in truth.
  LiveDrive(const LiveArguments& arguments, const Map& drawing, std::uint64_t seed);
  ~LiveDrive();
  LiveDrive(const LiveDrive&) = delete;
  LiveDrive& operator=(const LiveDrive&) = delete;

  /// Waits for the first observation; nullptr when the drive was ended before it. What the devices
  /// have to say is told through `progress` until this object goes; `interrupt` ends the drive.
  std::unique_ptr<ObservationSource> open(const Interrupt& interrupt, Progress& progress);

  /// What was found last, for whoever looks on.
  void tell(const std::shared_ptr<const Snapshot>& snapshot) const;

  /// Whether somebody may look on who can say where the robot is.
  bool mayBeGivenPoses() const { return !job_.rig.publish.ros.empty(); }
  /// Where somebody who looks on said since that the robot is.
  std::optional<StampedPose> takeGivenPose();

  /// What was passed over and refused, and where it was recorded: a few lines for stderr.
  std::string summary() const;

 private:
  void watch(const std::stop_token& stop, Progress& progress) const;

  LiveJob job_;
  std::optional<double> for_s_;
  std::unique_ptr<QCoreApplication> application_;  ///< threads with an event loop need one
  std::mutex given_mutex_;
  std::optional<StampedPose> given_;  ///< under it
  std::unique_ptr<Onlookers> onlookers_;
  std::jthread watcher_;
};

}  // namespace handmap
