// The rays that placed a wall, and the wall itself: why it stands where it stands.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <QPolygonF>
#include <optional>

#include "core/explain/wall_story.h"
#include "widgets/style/colours.h"

namespace handmap {

class RaysItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  /// `chosen`: one of the witnesses, drawn stronger than the others. nullptr: nothing.
  void setStory(const WallStory* story, std::optional<std::size_t> chosen);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QList<QLineF> others_;
  QList<QLineF> chosen_;
  QPolygonF returns_;
  QLineF wall_;
  QRectF bounds_;
};

}  // namespace handmap
