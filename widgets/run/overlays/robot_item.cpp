#include "widgets/run/overlays/robot_item.h"

#include <QPainter>

namespace handmap {

RobotItem::RobotItem(Role role) : role_(role) { setFlag(ItemIgnoresTransformations); }

void RobotItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void RobotItem::setPose(const Pose2& pose) {
  heading_ = pose.heading;
  setPos(pose.x, pose.y);
  update();
}

void RobotItem::setViewTurn(double turn_rad) {
  view_turn_ = turn_rad;
  update();
}

void RobotItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  static const QPolygonF kArrow({{11.0, 0.0}, {-7.0, 7.5}, {-3.5, 0.0}, {-7.0, -7.5}});
  painter->setRenderHint(QPainter::Antialiasing);
  painter->rotate(-toDegrees(heading_ + view_turn_));  // pixels: y points down
  if (role_ == Role::Truth) {
    painter->setPen(colours_->pen(role_));
    painter->setBrush(Qt::NoBrush);
  } else {
    painter->setPen(QPen((*colours_)[Role::TextHalo], 1.5));
    painter->setBrush((*colours_)[role_]);
  }
  painter->drawPolygon(kArrow);
}

}  // namespace handmap
