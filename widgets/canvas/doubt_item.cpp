#include "widgets/canvas/doubt_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <cmath>

#include "core/map/map_flags.h"
#include "core/map/map_layers.h"

namespace handmap {

namespace {

constexpr double kLeastPx = 2.0;  ///< a narrower edge is not seen
constexpr std::size_t kMostEdges = 400;
constexpr int kRings = 5;
constexpr int kRingAlpha = 9;
constexpr double kMarkPx = 14.0;

/// Of a wall: the place of the building and half of what its size is off.
double sigmaOfWall(const Uncertainty& uncertainty) {
  return std::hypot(uncertainty.position, uncertainty.size / 2.0);
}

}  // namespace

DoubtItem::DoubtItem(const MapDocument& document) : document_(document) {
  setFlag(ItemUsesExtendedStyleOption);  // for exposedRect
  rebuild();
}

void DoubtItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void DoubtItem::rebuild() {
  prepareGeometryChange();
  const Map& map = document_.map();
  edges_.clear();
  bounds_ = {};
  if (stateOf(layersOf(map), DrawingLayer::Buildings).hidden) return;
  edges_.reserve(map.buildings.size());
  for (const Building& building : map.buildings) {
    if (isHidden(building)) continue;
    Edge edge{{}, {}, sigmaOfWall(map.uncertaintyOf(building)), mayNotExist(building)};
    for (const Vec2& corner : building.footprint()) edge.outline << QPointF(corner.x(), corner.y());
    const double reach = edge.sigma;
    edge.bounds = edge.outline.boundingRect().adjusted(-reach, -reach, reach, reach);
    bounds_ |= edge.bounds;
    edges_.push_back(std::move(edge));
  }
  update();
}

void DoubtItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const double pixels_per_metre =
      std::hypot(painter->worldTransform().m11(), painter->worldTransform().m12());
  std::vector<const Edge*> seen;
  for (const Edge& edge : edges_) {
    const bool is_soft = edge.sigma * pixels_per_metre >= kLeastPx || edge.may_not_exist;
    if (!is_soft || !edge.bounds.intersects(option->exposedRect)) continue;
    seen.push_back(&edge);
    if (seen.size() > kMostEdges) return;  // from so far away it would only be fog
  }
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  QColor ink = (*colours_)[Role::Drawing];
  ink.setAlpha(kRingAlpha);
  for (const Edge* edge : seen) {
    for (int ring = 1; ring <= kRings; ++ring) {
      painter->setPen(QPen(ink, 2.0 * edge->sigma * ring / kRings, Qt::SolidLine, Qt::SquareCap,
                           Qt::RoundJoin));
      painter->drawPolygon(edge->outline);
    }
  }
  const QTransform to_device = painter->worldTransform();
  painter->save();  // others write with the font that they find
  painter->setWorldTransform({});
  painter->setPen((*colours_)[Role::Doubtful]);
  QFont font = painter->font();
  font.setBold(true);
  painter->setFont(font);
  for (const Edge* edge : seen) {
    if (!edge->may_not_exist) continue;
    const QRectF on_device = to_device.map(edge->outline).boundingRect();
    painter->drawText(
        QRectF(on_device.right() - kMarkPx - 2.0, on_device.top() + 2.0, kMarkPx, kMarkPx + 2.0),
        Qt::AlignCenter, QStringLiteral("?"));
  }
  painter->restore();
}

}  // namespace handmap
