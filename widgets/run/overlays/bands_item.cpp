#include "widgets/run/overlays/bands_item.h"

#include <QPainter>

#include "widgets/run/overlays/scene_points.h"
#include "widgets/run/overlays/wall_bands.h"

namespace handmap {

void BandsItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void BandsItem::setMap(const Map& map) {
  prepareGeometryChange();
  bands_ = {};
  bands_.setFillRule(Qt::WindingFill);  // where two meet they are no darker
  for (const Building& building : map.buildings) {
    if (!building.estimate) continue;
    for (Polygon& band : wallBands(building)) {
      if (signedArea(band) < 0.0) std::ranges::reverse(band);
      bands_.addPolygon(toScene(band));
      bands_.closeSubpath();
    }
  }
}

void BandsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing, false);  // nobody sees it, and it takes long
  painter->fillPath(bands_, colours_->brush(Role::CorrectedBand));
}

}  // namespace handmap
