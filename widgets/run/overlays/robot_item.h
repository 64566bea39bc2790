// The robot, of one size at every zoom: an arrow head on a disc.
#pragma once

#include <QGraphicsItem>

#include "core/geometry/pose2.h"
#include "widgets/style/colours.h"

namespace handmap {

class RobotItem : public QGraphicsItem {
 public:
  /// Truth: hollow and dashed.
  explicit RobotItem(Role role);

  void setColours(const Colours& colours);
  void setPose(const Pose2& pose);
  /// How the map is turned where it is shown, radians, counter-clockwise.
  void setViewTurn(double turn_rad);

  QRectF boundingRect() const override { return {-14.0, -14.0, 28.0, 28.0}; }  // pixels
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  Role role_;
  const Colours* colours_ = &Colours::light();
  double heading_ = 0.0;
  double view_turn_ = 0.0;
};

}  // namespace handmap
