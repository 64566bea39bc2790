#include "widgets/canvas/map_picture.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>

#include "widgets/canvas/drawing_item.h"
#include "widgets/document/map_document.h"

namespace handmap {

QImage pictureOf(const Map& map, QSize size, const Colours& colours) {
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(colours[Role::Background]);
  const auto bounds = boundsOf(map);
  if (!bounds) return picture;
  constexpr double kMargin = 0.06;
  constexpr double kLeastMetres = 1.0;  // a start alone has no size
  const Vec2 extent = (bounds->high - bounds->low).cwiseMax(kLeastMetres);
  const Vec2 middle = 0.5 * (bounds->low + bounds->high);
  const double scale =
      (1.0 - 2.0 * kMargin) * std::min(size.width() / extent.x(), size.height() / extent.y());

  MapDocument document;
  document.reset(map);
  DrawingItem item(document);
  item.setColours(colours);
  QPainter painter(&picture);
  painter.translate(size.width() / 2.0, size.height() / 2.0);
  painter.scale(scale, -scale);
  painter.translate(-middle.x(), -middle.y());
  QStyleOptionGraphicsItem option;
  option.exposedRect = item.boundingRect();
  item.paint(&painter, &option, nullptr);
  const QTransform to_device = painter.worldTransform();
  painter.resetTransform();
  item.paintLabels(painter, to_device, option.exposedRect);
  return picture;
}

}  // namespace handmap
