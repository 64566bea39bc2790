// Where the observations of a run come from: a recording, the simulator or a live robot.
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "core/recording/recording.h"
#include "core/rendering/rendered_recording.h"
#include "core/session/acts.h"
#include "core/simulation/world.h"

namespace handmap {

class LiveLink;

struct Robot {
  QString name;
  std::vector<StampedPose> truth;  ///< to be drawn before the run, may be empty
  std::optional<Map> truth_map;    ///< where it is known: to be drawn, and to score the run
  QString opening;  ///< what it does before the first observation, where that takes long
  /// It has no end: a run with it ends when the person ends the drive. nullptr for all others.
  std::shared_ptr<LiveLink> live = {};
  /// What a person said while it was recorded: a run does it again.
  std::vector<Act> acts = {};
  QString folder = {};  ///< of a recording; empty: it is none
  std::shared_ptr<const Recording> recording = {};
  int first_frame = 0;  ///< of a recording
  int last_frame = 0;
  /// Called in the thread of the run. The options are those of recordings. Tells the share done of
  /// opening. nullptr when the stop was requested before it was done.
  std::function<std::unique_ptr<ObservationSource>(const ReplayOptions&, const std::stop_token&,
                                                   const std::function<void(double)>&)>
      connect;
};

Robot recordedRobot(std::shared_ptr<const Recording> recording);
Robot simulatedRobot(const QString& name, World world, std::uint64_t seed);
/// Sees rendered images; they are rendered into `folder` the first time.
Robot renderedRobot(const QString& name, RenderedDrive drive, const QString& folder);

}  // namespace handmap
