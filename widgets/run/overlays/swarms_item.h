// The swarms of a run in one item: the outline of every member.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <vector>

#include "core/method/snapshot.h"
#include "widgets/style/colours.h"

namespace handmap {

class SwarmsItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setSwarms(const std::vector<SwarmView>& swarms);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QList<QLineF> outlines_;
  QRectF bounds_;
};

}  // namespace handmap
