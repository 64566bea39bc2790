// What one phase of an observation has found, over everything else: walls, outlines of buildings,
// and what each is taken for.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <QPainterPath>

#include "core/method/phase.h"
#include "widgets/style/colours.h"

namespace handmap {

class PhaseItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setPhase(const Phase* phase);  ///< nullptr: none

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QList<QLineF> walls_;
  QPainterPath outlines_;
  QList<QLineF> links_;
  QRectF bounds_;
};

}  // namespace handmap
