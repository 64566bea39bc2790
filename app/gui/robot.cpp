#include "app/gui/robot.h"

#include <QObject>

#include "core/odometry/visual_odometry_source.h"
#include "core/simulation/simulated_source.h"

namespace handmap {

Robot recordedRobot(std::shared_ptr<const Recording> recording) {
  Robot robot;
  robot.name = QString::fromStdString(recording->name);
  robot.truth = recording->truth.poses();
  robot.connect = [recording = std::move(recording)](const ReplayOptions& options) {
    return replayWithOdometry(*recording, options);
  };
  return robot;
}

Robot simulatedRobot(const QString& name, World world, std::uint64_t seed) {
  Robot robot;
  robot.name = QObject::tr("Simulator: %1").arg(name);
  robot.truth_map = world.map;
  robot.connect = [world = std::move(world), seed](const ReplayOptions&) {
    return simulate(world, SimulationOptions(), seed);
  };
  return robot;
}

}  // namespace handmap
