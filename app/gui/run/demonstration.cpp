#include "app/gui/run/demonstration.h"

#include <QFile>
#include <QObject>
#include <QStandardPaths>

#include "app/gui/run/live_robot.h"
#include "core/map/map_io.h"

namespace handmap {

namespace {

constexpr std::uint64_t kDemonstrationSeed = 7;
constexpr double kSketchSigmaM = 5.0;

Map bundledMap(const QString& name) {
  QFile file(QStringLiteral(":/demo/%1.handmap").arg(name));
  if (!file.open(QIODevice::ReadOnly)) qFatal("%s is not bundled", qPrintable(name));
  return parseMap(file.readAll().toStdString(), name.toStdString());
}

Demonstration simulationOf(const QString& name, const World& world, std::uint64_t seed) {
  Demonstration simulation;
  simulation.sketch = perturbed(world.map, kSketchSigmaM, seed);
  simulation.sketch.name = QObject::tr("Sketch of %1").arg(name).toStdString();
  simulation.sketch.uncertainty = {kSketchSigmaM, kSketchSigmaM};
  simulation.robot = simulatedRobot(name, world, seed);
  return simulation;
}

}  // namespace

Demonstration demonstration() {
  RenderedDrive drive;
  drive.world =
      furnished(worldFromMap(bundledMap("two-rows-truth"), kDemonstrationSeed), kDemonstrationSeed);
  drive.seed = kDemonstrationSeed;
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::CacheLocation) +
                         QStringLiteral("/demonstration-" HANDMAP_VERSION);
  return {bundledMap("two-rows-sketch"),
          renderedRobot(QObject::tr("demonstration"), std::move(drive), folder)};
}

Demonstration twoRowSimulation(std::uint64_t seed) {
  return simulationOf(QObject::tr("two rows"), twoRowWorld(seed), seed);
}

Demonstration liveSimulation(std::uint64_t seed, VirtualRigKind kind) {
  World world = twoRowWorld(seed);
  if (kind == VirtualRigKind::StereoHead) world = furnished(std::move(world), seed);
  Demonstration simulation = simulationOf(QObject::tr("two rows"), world, seed);
  simulation.robot = virtualRobot(world, seed, kind);
  return simulation;
}

Demonstration campusSimulation(std::uint64_t seed) {
  return simulationOf(QObject::tr("a campus"), campusWorld(seed), seed);
}

Demonstration loopSimulation(std::uint64_t seed) {
  return simulationOf(QObject::tr("around a campus"), loopWorld(seed), seed);
}

Demonstration quarterSimulation(std::uint64_t seed) {
  return simulationOf(QObject::tr("a quarter"), quarterWorld(seed), seed);
}

Robot simulationOfDrawing(const Map& drawing, std::uint64_t seed) {
  const double sigma = drawing.uncertainty.position;
  // Once as it is: only a drawing that one can drive through can be made a world of.
  worldFromMap(drawing, seed);
  return simulatedRobot(QObject::tr("this drawing"),
                        worldFromMap(perturbed(drawing, sigma, seed), seed), seed);
}

}  // namespace handmap
