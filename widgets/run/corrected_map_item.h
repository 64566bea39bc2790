// The buildings that a run has refined: solid outlines with translucent bands of one standard
// deviation around each wall.
#pragma once

#include <QGraphicsItem>
#include <QPainterPath>

#include "core/map/map.h"
#include "widgets/style/colours.h"

namespace handmap {

class CorrectedMapItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  void setMap(const Map& map);  ///< buildings without an estimate are left out
  void setOutlinesVisible(bool visible);
  void setBandsVisible(bool visible);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  QPainterPath outlines_;
  std::vector<QPainterPath> bands_;
  QRectF bounds_;
  bool outlines_visible_ = true;
  bool bands_visible_ = true;
};

}  // namespace handmap
