// How sure the run is of the robot's pose: the ellipse of one standard deviation of the position
// and the rays of one of the heading.
#pragma once

#include <QGraphicsItem>

#include "core/method/snapshot.h"
#include "widgets/style/colours.h"

namespace handmap {

class PoseSpreadItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setReport(const FrameReport& report);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QPolygonF ellipse_;
  QPointF at_;
  QPolygonF heading_;  ///< unit vectors of both ends of the heading's one sigma
  QRectF bounds_;
};

}  // namespace handmap
