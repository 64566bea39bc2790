// The buildings that a run has refined: outlines, solid where a wall was seen and dashed where it
// stands as the drawing has it; what is doubtful is hatched.
#pragma once

#include <QGraphicsItem>
#include <QHash>
#include <QLineF>
#include <QList>
#include <QPainterPath>
#include <QPolygonF>
#include <QStringList>

#include "core/map/map.h"
#include "widgets/style/colours.h"

namespace handmap {

class CorrectedMapItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  static QPen unseenPen(const Colours& colours);  ///< of a wall that nobody saw
  void setMap(const Map& map);                    ///< buildings without an estimate are left out

  void setSelected(const QStringList& ids);
  /// Then walls have a casing.
  void setOnPicture(bool on) { on_picture_ = on; }

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QList<QLineF> seen_;     ///< walls
  QList<QLineF> unseen_;   ///< walls
  QPainterPath doubtful_;  ///< footprints
  QHash<QString, QPolygonF> outlines_;
  QStringList selected_;
  bool on_picture_ = false;
  QRectF bounds_;
};

}  // namespace handmap
