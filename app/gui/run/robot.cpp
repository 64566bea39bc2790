#include "app/gui/run/robot.h"

#include <QObject>

#include "core/simulation/simulated_source.h"
#include "core/trajectory/odometry_choice.h"

namespace handmap {

Robot recordedRobot(std::shared_ptr<const Recording> recording) {
  Robot robot;
  robot.name = QString::fromStdString(recording->name);
  robot.truth = recording->truth.poses();
  robot.folder = QString::fromStdString(recording->folder.string());
  robot.recording = recording;
  if (!recording->rows.empty()) {
    robot.first_frame = recording->rows.front().frame;
    robot.last_frame = recording->rows.back().frame;
  }
  robot.connect = [recording = std::move(recording)](const ReplayOptions& options,
                                                     const std::stop_token&,
                                                     const std::function<void(double)>&) {
    return replayWithOdometry(*recording, options, OdometryKind::Recorded).source;
  };
  return robot;
}

Robot simulatedRobot(const QString& name, World world, std::uint64_t seed) {
  Robot robot;
  robot.name = QObject::tr("Simulator: %1").arg(name);
  robot.truth_map = world.map;
  robot.connect = [world = std::move(world), seed](const ReplayOptions&, const std::stop_token&,
                                                   const std::function<void(double)>&) {
    return simulate(world, SimulationOptions(), seed);
  };
  return robot;
}

Robot renderedRobot(const QString& name, RenderedDrive drive, const QString& folder) {
  Robot robot;
  robot.name = QObject::tr("Simulator: %1").arg(name);
  robot.opening = QObject::tr("Rendering what the cameras see");
  robot.truth_map = drive.world.map;
  robot.connect = [drive = std::move(drive), path = folder.toStdString()](
                      const ReplayOptions&, const std::stop_token& stop,
                      const std::function<void(double)>&) {
    return renderedOnce(drive, path, stop);
  };
  return robot;
}

}  // namespace handmap
