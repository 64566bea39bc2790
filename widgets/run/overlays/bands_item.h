// Where the corrected walls may be: translucent, one standard deviation to both sides of each.
#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

#include "core/map/map.h"
#include "widgets/style/colours.h"

namespace handmap {

class BandsItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setMap(const Map& map);

  QRectF boundingRect() const override { return bands_.boundingRect(); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QPainterPath bands_;
};

}  // namespace handmap
