#include "widgets/run/swarms_item.h"

#include <QPainter>

#include "widgets/run/scene_points.h"

namespace handmap {

void SwarmsItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void SwarmsItem::setSwarms(const std::vector<SwarmView>& swarms) {
  prepareGeometryChange();
  outlines_ = {};
  for (const SwarmView& swarm : swarms) {
    for (const Polygon& member : swarm.members) {
      outlines_.addPolygon(toScene(member));
      outlines_.closeSubpath();
    }
  }
}

void SwarmsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  painter->strokePath(outlines_, colours_->pen(Role::Swarm));
}

}  // namespace handmap
