// Where the observations of a run come from: a recording or the simulator.
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "core/recording/recording.h"
#include "core/simulation/world.h"

namespace handmap {

struct Robot {
  QString name;
  std::vector<StampedPose> truth;  ///< to be drawn before the run, may be empty
  std::optional<Map> truth_map;    ///< where it is known: to be drawn, and to score the run
  /// Called in the thread of the run. The options are those of recordings.
  std::function<std::unique_ptr<ObservationSource>(const ReplayOptions&)> connect;
};

Robot recordedRobot(std::shared_ptr<const Recording> recording);
Robot simulatedRobot(const QString& name, World world, std::uint64_t seed);

}  // namespace handmap
