#include "widgets/run/overlays/swarms_item.h"

#include <QPainter>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

void SwarmsItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void SwarmsItem::setSwarms(const std::vector<SwarmView>& swarms) {
  prepareGeometryChange();
  outlines_.clear();
  bounds_ = {};
  for (const SwarmView& swarm : swarms) {
    for (const Polygon& member : swarm.members) {
      const QPolygonF outline = toScene(member);
      appendSides(outline, outlines_);
      bounds_ |= outline.boundingRect();
    }
  }
}

void SwarmsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing, false);  // a cloud of lines, far faster
  painter->setPen(colours_->pen(Role::Swarm));
  painter->drawLines(outlines_);
}

}  // namespace handmap
