#include "widgets/run/overlays/averaged_image.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>

namespace handmap {

QImage averagedFor(const QPainter& painter, const QRectF& area, const QImage& image) {
  const double pixels_per_metre =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter.worldTransform()) *
      painter.device()->devicePixelRatioF();
  const QSize shown = (area.size() * pixels_per_metre).toSize().expandedTo({1, 1});
  const QSize wanted = shown.boundedTo(image.size());
  if (wanted == image.size()) return image;
  return image.scaled(wanted, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace handmap
