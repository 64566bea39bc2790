// The swarms of a run in one item: the outline of every member.
#pragma once

#include <QGraphicsItem>
#include <QPainterPath>
#include <vector>

#include "core/session/snapshot.h"
#include "widgets/style/colours.h"

namespace handmap {

class SwarmsItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setSwarms(const std::vector<SwarmView>& swarms);

  QRectF boundingRect() const override { return outlines_.boundingRect(); }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QPainterPath outlines_;
};

}  // namespace handmap
