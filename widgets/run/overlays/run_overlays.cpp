#include "widgets/run/overlays/run_overlays.h"

#include <QGraphicsScene>
#include <algorithm>

#include "core/map/certainty.h"
#include "widgets/run/overlays/bands_item.h"
#include "widgets/run/overlays/changes_item.h"
#include "widgets/run/overlays/corrected_map_item.h"
#include "widgets/run/overlays/local_map_item.h"
#include "widgets/run/overlays/particles_item.h"
#include "widgets/run/overlays/path_item.h"
#include "widgets/run/overlays/phase_item.h"
#include "widgets/run/overlays/pose_spread_item.h"
#include "widgets/run/overlays/rays_item.h"
#include "widgets/run/overlays/robot_item.h"
#include "widgets/run/overlays/scene_points.h"
#include "widgets/run/overlays/seen_item.h"
#include "widgets/run/overlays/swarms_item.h"

namespace handmap {

namespace {

/// What lies ahead of the robot would look like a way that it plans.
std::vector<StampedPose> until(double time_s, const std::vector<StampedPose>& way) {
  const auto ahead = std::ranges::upper_bound(way, time_s, {}, &StampedPose::time_s);
  return {way.begin(), ahead};
}

}  // namespace

RunOverlays::RunOverlays(QGraphicsScene& scene, double z, QObject* parent)
    : QObject(parent),
      sight_(std::make_unique<SeenItem>(SeenItem::Part::Sight)),
      local_map_(std::make_unique<LocalMapItem>()),
      swarms_(std::make_unique<SwarmsItem>()),
      bands_(std::make_unique<BandsItem>()),
      corrected_(std::make_unique<CorrectedMapItem>()),
      truth_(std::make_unique<PathItem>(Role::Truth)),
      odometry_(std::make_unique<PathItem>(Role::Odometry)),
      trajectory_(std::make_unique<PathItem>(Role::Trajectory)),
      points_(std::make_unique<SeenItem>(SeenItem::Part::Points)),
      seen_walls_(std::make_unique<SeenItem>(SeenItem::Part::Walls)),
      rays_(std::make_unique<RaysItem>()),
      particles_(std::make_unique<ParticlesItem>()),
      pose_spread_(std::make_unique<PoseSpreadItem>()),
      true_robot_(std::make_unique<RobotItem>(Role::Truth)),
      robot_(std::make_unique<RobotItem>(Role::Trajectory)),
      changes_(std::make_unique<ChangesItem>()),
      phase_(std::make_unique<PhaseItem>()) {
  for (const LayerSpec& spec : kLayers) visible_[static_cast<std::size_t>(spec.layer)] = spec.usual;
  *shows_local_map_ = isOn(Layer::LocalMap);
  for (QGraphicsItem* item : std::initializer_list<QGraphicsItem*>{
           sight_.get(), local_map_.get(), swarms_.get(), bands_.get(), corrected_.get(),
           truth_.get(), odometry_.get(), trajectory_.get(), points_.get(), seen_walls_.get(),
           rays_.get(), particles_.get(), pose_spread_.get(), true_robot_.get(), robot_.get(),
           changes_.get(), phase_.get()}) {
    item->setZValue(z);
    item->setAcceptedMouseButtons(Qt::NoButton);
    scene.addItem(item);
    z += 1.0;
  }
  updateVisibility();
}

RunOverlays::~RunOverlays() = default;

void RunOverlays::setColours(const Colours& colours) {
  for (SeenItem* item : {sight_.get(), points_.get(), seen_walls_.get()}) {
    item->setColours(colours);
  }
  local_map_->setColours(colours);
  swarms_->setColours(colours);
  bands_->setColours(colours);
  corrected_->setColours(colours);
  truth_->setColours(colours);
  odometry_->setColours(colours);
  trajectory_->setColours(colours);
  rays_->setColours(colours);
  particles_->setColours(colours);
  pose_spread_->setColours(colours);
  true_robot_->setColours(colours);
  robot_->setColours(colours);
  changes_->setColours(colours);
  phase_->setColours(colours);
}

std::vector<QGraphicsItem*> RunOverlays::itemsOf(Layer layer) const {
  switch (layer) {
    case Layer::LocalMap:
      return {local_map_.get()};
    case Layer::Swarms:
      return {swarms_.get()};
    case Layer::Band:
      return {bands_.get()};
    case Layer::Corrected:
      return {corrected_.get()};
    case Layer::Changes:
      return {changes_.get()};
    case Layer::PoseSpread:
      return {pose_spread_.get()};
    case Layer::Rays:
      return {rays_.get()};
    case Layer::Particles:
      return {particles_.get()};
    case Layer::Trajectory:
      return {trajectory_.get(), robot_.get()};
    case Layer::Odometry:
      return {odometry_.get()};
    case Layer::Points:
      return {points_.get()};
    case Layer::SeenWalls:
      return {seen_walls_.get()};
    case Layer::Sight:
      return {sight_.get()};
    case Layer::Truth:
      return {truth_.get(), true_robot_.get()};
    default:
      return {};
  }
}

void RunOverlays::setLayerVisible(Layer layer, bool visible) {
  visible_[static_cast<std::size_t>(layer)] = visible;
  if (layer == Layer::LocalMap) *shows_local_map_ = visible;
  updateVisibility();
  if (layer == Layer::Corrected) tellOutlines();
  if (layer == Layer::SeenWalls && visible) showSeen();
}

void RunOverlays::setSelected(const QStringList& ids) { corrected_->setSelected(ids); }

void RunOverlays::setOnPicture(bool on) { corrected_->setOnPicture(on); }

void RunOverlays::setLayerOpacity(Layer layer, double share) {
  for (QGraphicsItem* item : itemsOf(layer)) item->setOpacity(share);
}

void RunOverlays::setViewTurn(double turn_rad) {
  robot_->setViewTurn(turn_rad);
  true_robot_->setViewTurn(turn_rad);
}

void RunOverlays::updateVisibility() {
  for (const LayerSpec& spec : kLayers) {
    for (QGraphicsItem* item : itemsOf(spec.layer)) {
      item->setVisible(has_snapshot_ && isOn(spec.layer));
    }
  }
  truth_->setVisible(isOn(Layer::Truth));
  true_robot_->setVisible(has_true_pose_ && isOn(Layer::Truth));
  rays_->setVisible(has_story_ && isOn(Layer::Rays));
}

void RunOverlays::setDrawing(const Map& drawing) { drawing_ = drawing; }

void RunOverlays::setTruth(const std::vector<StampedPose>& trajectory) {
  true_way_ = trajectory;
  truth_->setPoses(trajectory);
  Q_EMIT truthChanged(trajectory);
}

void RunOverlays::setTruthMap(const Map& truth) {
  truth_->setBuildings(truth.buildings);
  true_middles_.emplace(truth);
}

void RunOverlays::show(const Snapshot& snapshot) {
  phase_->setPhase(nullptr);
  display(snapshot);
  Q_EMIT shown(snapshot);
}

std::function<void(const Snapshot&)> RunOverlays::preparation() const {
  return [shows_local_map = shows_local_map_](const Snapshot& snapshot) {
    if (snapshot.map) snapshot.map.get();
    if (snapshot.local_map && *shows_local_map) snapshot.local_map.get();
  };
}

void RunOverlays::showPhase(const Phase& phase) {
  phase_->setPhase(&phase);
  display(phase.shown);
}

void RunOverlays::display(const Snapshot& snapshot) {
  has_snapshot_ = true;
  has_true_pose_ = snapshot.truth.has_value();
  local_map_->setLocalMap(snapshot.local_map, snapshot.report.pose);
  swarms_->setSwarms(snapshot.swarms);
  if (snapshot.map) showMap(*snapshot.map);
  const double now_s = snapshot.report.time_s;
  odometry_->setPoses(until(now_s, snapshot.odometry.all()));
  shown_trajectory_ = snapshot.trajectory.all();
  trajectory_->setPoses(until(now_s, shown_trajectory_));
  particles_->setParticles(snapshot.particles);
  pose_spread_->setReport(snapshot.report);
  robot_->setPose(snapshot.report.pose);
  if (snapshot.truth) true_robot_->setPose(*snapshot.truth);
  truth_->setPoses(until(now_s, true_way_));
  seen_ = snapshot.seen.lock();
  seen_from_ = snapshot.report.pose;
  if (snapshot.local_map) seen_range_m_ = snapshot.local_map.range();
  showSeen();
  updateVisibility();
}

void RunOverlays::showSeen() {
  points_->setSeen(seen_, seen_from_, seen_range_m_);
  sight_->setSeen(seen_, seen_from_, seen_range_m_);
  if (!isOn(Layer::SeenWalls)) return;
  const bool known = seen_ && shown_map_;
  seen_walls_->setWalls(known ? seenWalls(*shown_map_, seen_from_, seen_->percept.scan)
                              : std::vector<SeenWall>());
}

void RunOverlays::showMap(const Map& map) {
  shown_map_ = map;
  corrected_->setMap(map);
  bands_->setMap(map);
  changes_->setChanges(drawing_, map);
  tellOutlines();
}

void RunOverlays::tellOutlines() {
  QHash<QString, QPolygonF> outlines;
  if (shown_map_ && isOn(Layer::Corrected)) {
    for (const Building& building : shown_map_->buildings) {
      if (!isRecognised(building)) continue;
      outlines.insert(QString::fromStdString(building.id), toScene(building.footprint()));
    }
  }
  Q_EMIT outlinesChanged(outlines);
}

void RunOverlays::showStory(const WallStory* story, std::optional<std::size_t> chosen_witness) {
  has_story_ = story != nullptr;
  rays_->setStory(story, chosen_witness);
  updateVisibility();
}

void RunOverlays::clear() {
  has_snapshot_ = false;
  has_true_pose_ = false;
  true_middles_.reset();
  true_way_.clear();
  shown_map_.reset();
  shown_trajectory_.clear();
  truth_->setPoses({});
  truth_->setBuildings({});
  local_map_->setLocalMap({}, {});
  seen_.reset();
  showSeen();
  phase_->setPhase(nullptr);
  changes_->clear();
  showStory(nullptr, {});
  tellOutlines();
  Q_EMIT cleared();
}

}  // namespace handmap
