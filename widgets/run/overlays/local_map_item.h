// The grid of walls that the robot sees, laid where the robot stands.
#pragma once

#include <QGraphicsItem>
#include <QImage>
#include <memory>

#include "core/geometry/pose2.h"
#include "core/perception/local_map.h"
#include "widgets/style/colours.h"

namespace handmap {

class LocalMapItem : public QGraphicsItem {
 public:
  void setColours(const Colours& colours);
  /// An empty one shows nothing. It is rendered when it is first painted.
  void setLocalMap(LazyLocalMap local_map, const Pose2& robot);

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  const Colours* colours_ = &Colours::light();
  LazyLocalMap local_map_;
  QImage image_;           ///< of local_map_ in the colours; made when first painted
  int cells_a_pixel_ = 1;  ///< of image_, either way
};

}  // namespace handmap
