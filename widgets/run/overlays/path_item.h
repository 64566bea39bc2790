// Trajectories and outlines in one pen: a trajectory, the odometry alone, the truth.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <QPolygonF>
#include <vector>

#include "core/map/map.h"
#include "core/recording/trajectory.h"
#include "widgets/style/colours.h"

namespace handmap {

class PathItem : public QGraphicsItem {
 public:
  explicit PathItem(Role role) : role_(role) {}

  void setColours(const Colours& colours);
  void setPoses(const std::vector<StampedPose>& poses);
  /// Beside the way.
  void setBuildings(const std::vector<Building>& buildings);

  QRectF boundingRect() const override { return line_bounds_ | outlines_bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  Role role_;
  const Colours* colours_ = &Colours::light();
  QPolygonF line_;
  QList<QLineF> outlines_;
  QRectF line_bounds_;
  QRectF outlines_bounds_;
};

}  // namespace handmap
