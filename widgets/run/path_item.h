// Ways and outlines in one pen: a trajectory, the odometry alone, the truth.
#pragma once

#include <QGraphicsPathItem>
#include <vector>

#include "core/map/map.h"
#include "core/recording/trajectory.h"
#include "widgets/style/colours.h"

namespace handmap {

class PathItem : public QGraphicsPathItem {
 public:
  explicit PathItem(Role role) : role_(role) { setColours(Colours::light()); }

  void setColours(const Colours& colours);
  void setPoses(const std::vector<StampedPose>& poses);
  /// Beside the way.
  void setBuildings(const std::vector<Building>& buildings);

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void join();

  Role role_;
  QPolygonF way_;
  QPainterPath outlines_;
};

}  // namespace handmap
