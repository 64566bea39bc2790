// What a run shows on the canvas. Every kind of thing is one item of the scene, whatever the number
// of particles or frames.
#pragma once

#include <QHash>
#include <QObject>
#include <QPolygonF>
#include <QStringList>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "core/explain/wall_story.h"
#include "core/map/map_changes.h"
#include "core/method/phase.h"
#include "core/method/snapshot.h"
#include "widgets/run/overlays/layers.h"

class QGraphicsItem;
class QGraphicsScene;

namespace handmap {

class BandsItem;
class ChangesItem;
class CorrectedMapItem;
class LocalMapItem;
class ParticlesItem;
class PathItem;
class PhaseItem;
class PoseSpreadItem;
class RaysItem;
class RobotItem;
class SeenItem;
class SwarmsItem;

class RunOverlays : public QObject {
  Q_OBJECT
  Q_DISABLE_COPY(RunOverlays)
 public:
  /// The items lie on `scene` (metres, y up) from `z` upwards and go with this object, which must
  /// not outlive the scene.
  RunOverlays(QGraphicsScene& scene, double z, QObject* parent = nullptr);
  ~RunOverlays() override;

  void setColours(const Colours& colours);
  void setLayerVisible(Layer layer, bool visible);  ///< layers that are not ours are ignored
  bool isShown(Layer layer) const { return isOn(layer); }
  /// By id: corrected buildings that are chosen.
  void setSelected(const QStringList& ids);
  void setOnPicture(bool on);                       ///< the map lies on a picture
  void setLayerOpacity(Layer layer, double share);  ///< the same
  /// The map is shown turned by so much, radians, counter-clockwise: signs of one size turn with
  /// it.
  void setViewTurn(double turn_rad);

  /// The drawing that the run was given: what is shown is compared with it.
  void setDrawing(const Map& drawing);
  const Map& drawing() const { return drawing_; }
  /// The truth is there from the start, where it is known.
  void setTruth(const std::vector<StampedPose>& trajectory);
  void setTruthMap(const Map& truth);
  const std::optional<TrueMiddles>& trueMiddles() const { return true_middles_; }
  /// Snapshots may come in any order.
  void show(const Snapshot& snapshot);
  /// Makes, in any thread, what show() would make, so that this one need not wait for it. May
  /// outlive this object.
  std::function<void(const Snapshot&)> preparation() const;
  /// In the middle of an observation; until the next show().
  void showPhase(const Phase& phase);
  void clear();
  /// nullptr: none.
  void showStory(const WallStory* story, std::optional<std::size_t> chosen_witness);

  /// The corrected map as it is shown; nullptr before there is one.
  const Map* shownMap() const { return shown_map_ ? &*shown_map_ : nullptr; }
  /// The way as it is shown.
  const std::vector<StampedPose>& shownTrajectory() const { return shown_trajectory_; }

 Q_SIGNALS:
  /// After show().
  void shown(const handmap::Snapshot& snapshot);
  void cleared();
  void truthChanged(const std::vector<handmap::StampedPose>& trajectory);
  /// By id: the outlines that labels of buildings stand on; empty where nothing is shown.
  void outlinesChanged(const QHash<QString, QPolygonF>& outlines);

 private:
  void display(const Snapshot& snapshot);
  void showMap(const Map& map);
  void showSeen();
  void tellOutlines();
  void updateVisibility();
  bool isOn(Layer layer) const { return visible_[static_cast<std::size_t>(layer)]; }
  std::vector<QGraphicsItem*> itemsOf(Layer layer) const;

  std::unique_ptr<SeenItem> sight_;
  std::unique_ptr<LocalMapItem> local_map_;
  std::unique_ptr<SwarmsItem> swarms_;
  std::unique_ptr<BandsItem> bands_;
  std::unique_ptr<CorrectedMapItem> corrected_;
  std::unique_ptr<PathItem> truth_;
  std::unique_ptr<PathItem> odometry_;
  std::unique_ptr<PathItem> trajectory_;
  std::unique_ptr<SeenItem> points_;
  std::unique_ptr<SeenItem> seen_walls_;
  std::unique_ptr<RaysItem> rays_;
  std::unique_ptr<ParticlesItem> particles_;
  std::unique_ptr<PoseSpreadItem> pose_spread_;
  std::unique_ptr<RobotItem> true_robot_;
  std::unique_ptr<RobotItem> robot_;
  std::unique_ptr<ChangesItem> changes_;
  std::unique_ptr<PhaseItem> phase_;
  std::array<bool, static_cast<std::size_t>(Layer::Count)> visible_;
  /// For preparation().
  std::shared_ptr<std::atomic<bool>> shows_local_map_ = std::make_shared<std::atomic<bool>>(true);
  Map drawing_;
  std::optional<TrueMiddles> true_middles_;
  std::optional<Map> shown_map_;
  std::vector<StampedPose> true_way_;
  std::vector<StampedPose> shown_trajectory_;
  std::shared_ptr<const Perceived> seen_;  ///< nullptr: not known, or no longer
  Pose2 seen_from_;
  double seen_range_m_ = 0.0;
  bool has_snapshot_ = false;
  bool has_true_pose_ = false;
  bool has_story_ = false;
};

}  // namespace handmap
