#include "widgets/run/run_overlays.h"

#include <QGraphicsScene>

#include "widgets/run/corrected_map_item.h"
#include "widgets/run/local_map_item.h"
#include "widgets/run/particles_item.h"
#include "widgets/run/path_item.h"
#include "widgets/run/robot_item.h"
#include "widgets/run/swarms_item.h"

namespace handmap {

RunOverlays::RunOverlays(QGraphicsScene& scene, double z, QObject* parent)
    : QObject(parent),
      local_map_(std::make_unique<LocalMapItem>()),
      swarms_(std::make_unique<SwarmsItem>()),
      corrected_(std::make_unique<CorrectedMapItem>()),
      truth_(std::make_unique<PathItem>(Role::Truth)),
      odometry_(std::make_unique<PathItem>(Role::Odometry)),
      trajectory_(std::make_unique<PathItem>(Role::Trajectory)),
      particles_(std::make_unique<ParticlesItem>()),
      true_robot_(std::make_unique<RobotItem>(Role::Truth)),
      robot_(std::make_unique<RobotItem>(Role::Trajectory)) {
  visible_.fill(true);
  for (QGraphicsItem* item : std::initializer_list<QGraphicsItem*>{
           local_map_.get(), swarms_.get(), corrected_.get(), truth_.get(), odometry_.get(),
           trajectory_.get(), particles_.get(), true_robot_.get(), robot_.get()}) {
    item->setZValue(z);
    item->setAcceptedMouseButtons(Qt::NoButton);
    scene.addItem(item);
    z += 1.0;
  }
  updateVisibility();
}

RunOverlays::~RunOverlays() = default;

void RunOverlays::setColours(const Colours& colours) {
  local_map_->setColours(colours);
  swarms_->setColours(colours);
  corrected_->setColours(colours);
  truth_->setColours(colours);
  odometry_->setColours(colours);
  trajectory_->setColours(colours);
  particles_->setColours(colours);
  true_robot_->setColours(colours);
  robot_->setColours(colours);
}

void RunOverlays::setLayerVisible(Layer layer, bool visible) {
  visible_[static_cast<std::size_t>(layer)] = visible;
  updateVisibility();
}

void RunOverlays::updateVisibility() {
  local_map_->setVisible(has_snapshot_ && isOn(Layer::LocalMap));
  swarms_->setVisible(has_snapshot_ && isOn(Layer::Swarms));
  corrected_->setVisible(has_snapshot_ && (isOn(Layer::Corrected) || isOn(Layer::Band)));
  corrected_->setOutlinesVisible(isOn(Layer::Corrected));
  corrected_->setBandsVisible(isOn(Layer::Band));
  truth_->setVisible(isOn(Layer::Truth));
  odometry_->setVisible(has_snapshot_ && isOn(Layer::Odometry));
  trajectory_->setVisible(has_snapshot_ && isOn(Layer::Trajectory));
  robot_->setVisible(has_snapshot_ && isOn(Layer::Trajectory));
  particles_->setVisible(has_snapshot_ && isOn(Layer::Particles));
  true_robot_->setVisible(has_true_pose_ && isOn(Layer::Truth));
}

void RunOverlays::setTruth(const std::vector<StampedPose>& way) { truth_->setPoses(way); }

void RunOverlays::setTruthMap(const Map& truth) { truth_->setBuildings(truth.buildings); }

void RunOverlays::show(const Snapshot& snapshot) {
  has_snapshot_ = true;
  has_true_pose_ = snapshot.truth.has_value();
  local_map_->setLocalMap(snapshot.local_map, snapshot.report.pose);
  swarms_->setSwarms(snapshot.swarms);
  if (snapshot.map) corrected_->setMap(*snapshot.map);
  odometry_->setPoses(snapshot.odometry.all());
  trajectory_->setPoses(snapshot.trajectory.all());
  particles_->setParticles(snapshot.particles);
  robot_->setPose(snapshot.report.pose);
  if (snapshot.truth) true_robot_->setPose(*snapshot.truth);
  updateVisibility();
}

void RunOverlays::clear() {
  has_snapshot_ = false;
  has_true_pose_ = false;
  truth_->setPoses({});
  truth_->setBuildings({});
  local_map_->setLocalMap({}, {});
  updateVisibility();
}

}  // namespace handmap
