// Arrows from where things are in truth to where they were drawn; a ring alone is a true place of
// which nothing was drawn.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <vector>

#include "core/sketch_study/sketch.h"

namespace handmap {

class ErrorArrowsItem : public QGraphicsItem {
 public:
  void setPairs(const std::vector<SketchPair>& pairs);
  void clear();

  const QList<QLineF>& arrows() const { return arrows_; }  ///< metres
  const QList<QPointF>& missing() const { return missing_; }
  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QList<QLineF> arrows_;
  QList<QPointF> missing_;
  QRectF bounds_;
};

}  // namespace handmap
