// Arrows from where buildings were drawn to where the run has them, with their lengths in metres
// and, where the truth is known, what is left of the error.
#pragma once

#include <QCoreApplication>
#include <QGraphicsItem>
#include <optional>
#include <vector>

#include "core/map/map_changes.h"
#include "widgets/style/colours.h"

namespace handmap {

class ChangesItem : public QGraphicsItem {
  Q_DECLARE_TR_FUNCTIONS(handmap::ChangesItem)
 public:
  void setColours(const Colours& colours);
  void setChanges(const Map& drawing, const Map& refined);
  void clear();

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Arrow {
    QLineF line;  ///< metres
    QString text;
    QRectF bounds;  ///< of the building now
  };

  const Colours* colours_ = &Colours::light();
  std::vector<Arrow> arrows_;
  QRectF bounds_;
};

}  // namespace handmap
