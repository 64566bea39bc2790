#include "widgets/run/corrected_map_item.h"

#include <QPainter>

#include "widgets/run/scene_points.h"
#include "widgets/run/wall_bands.h"

namespace handmap {

namespace {

QPainterPath closedPath(const Polygon& polygon) {
  QPainterPath path;
  path.addPolygon(toScene(polygon));
  path.closeSubpath();
  return path;
}

/// The ring between the footprint grown and shrunk by one sigma.
QPainterPath bandOf(const Building& building) {
  std::vector<double> offsets = wallSigmas(building);
  QPainterPath band = closedPath(offsetWalls(building.footprint(), offsets));
  for (double& offset : offsets) offset = -offset;
  const Polygon inner = offsetWalls(building.footprint(), offsets);
  if (!inner.empty()) band.addPath(closedPath(inner));
  band.setFillRule(Qt::OddEvenFill);
  return band;
}

}  // namespace

void CorrectedMapItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void CorrectedMapItem::setMap(const Map& map) {
  prepareGeometryChange();
  outlines_.clear();
  bands_.clear();
  bounds_ = {};
  for (const Building& building : map.buildings) {
    if (!building.estimate) continue;
    outlines_.addPath(closedPath(building.footprint()));
    bands_.push_back(bandOf(building));
    bounds_ |= bands_.back().boundingRect();
  }
  bounds_ = (bounds_ | outlines_.boundingRect()).adjusted(-2.0, -2.0, 2.0, 2.0);
}

void CorrectedMapItem::setOutlinesVisible(bool visible) {
  outlines_visible_ = visible;
  update();
}

void CorrectedMapItem::setBandsVisible(bool visible) {
  bands_visible_ = visible;
  update();
}

void CorrectedMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (bands_visible_) {
    for (const QPainterPath& band : bands_) {
      painter->fillPath(band, colours_->brush(Role::CorrectedBand));
    }
  }
  if (outlines_visible_) {
    painter->setPen(colours_->pen(Role::Corrected));
    painter->setBrush(Qt::NoBrush);
    painter->drawPath(outlines_);
  }
}

}  // namespace handmap
