// What a run shows on the canvas. Every kind of thing is one item of the scene, whatever the number
// of particles or frames.
#pragma once

#include <QObject>
#include <memory>

#include "core/session/snapshot.h"
#include "widgets/run/layers.h"

class QGraphicsScene;

namespace handmap {

class CorrectedMapItem;
class LocalMapItem;
class ParticlesItem;
class PathItem;
class RobotItem;
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

  /// The truth is there from the start, where it is known.
  void setTruth(const std::vector<StampedPose>& way);
  void setTruthMap(const Map& truth);
  void show(const Snapshot& snapshot);
  void clear();

 private:
  void updateVisibility();
  bool isOn(Layer layer) const { return visible_[static_cast<std::size_t>(layer)]; }

  std::unique_ptr<LocalMapItem> local_map_;
  std::unique_ptr<SwarmsItem> swarms_;
  std::unique_ptr<CorrectedMapItem> corrected_;
  std::unique_ptr<PathItem> truth_;
  std::unique_ptr<PathItem> odometry_;
  std::unique_ptr<PathItem> trajectory_;
  std::unique_ptr<ParticlesItem> particles_;
  std::unique_ptr<RobotItem> true_robot_;
  std::unique_ptr<RobotItem> robot_;
  std::array<bool, static_cast<std::size_t>(Layer::Count)> visible_;
  bool has_snapshot_ = false;
  bool has_true_pose_ = false;
};

}  // namespace handmap
