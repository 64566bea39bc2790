#include "widgets/comparing/error_arrows_item.h"

#include <QPainter>
#include <QWidget>

#include "widgets/canvas/symbols.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr double kRingPx = 4.0;
constexpr double kMarginM = 20.0;  // room for rings and heads when zoomed out far

}  // namespace

void ErrorArrowsItem::clear() {
  prepareGeometryChange();
  arrows_.clear();
  missing_.clear();
  bounds_ = {};
}

void ErrorArrowsItem::setPairs(const std::vector<SketchPair>& pairs) {
  clear();
  QPolygonF all;
  for (const SketchPair& pair : pairs) {
    const QPointF place(pair.place.x(), pair.place.y());
    all.append(place);
    if (!pair.drawn) {
      missing_.append(place);
      continue;
    }
    arrows_.append({place, {pair.drawn->x(), pair.drawn->y()}});
    all.append(arrows_.back().p2());
  }
  bounds_ = all.boundingRect().adjusted(-kMarginM, -kMarginM, kMarginM, kMarginM);
}

void ErrorArrowsItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* widget) {
  const Colours& colours = widget ? Colours::of(widget->palette()) : Colours::light();
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  const QPen dashed = colours.pen(Role::Truth);
  QPen solid = dashed;
  solid.setStyle(Qt::SolidLine);
  painter->setBrush(colours[Role::Background]);
  const auto ring = [&](const QPointF& at) {
    painter->setPen(solid);
    painter->drawEllipse(to_device.map(at), kRingPx, kRingPx);
  };
  for (const QLineF& arrow : arrows_) {
    painter->setPen(dashed);
    paintArrow(*painter, to_device.map(arrow));
    ring(arrow.p1());
  }
  for (const QPointF& place : missing_) ring(place);
  painter->restore();
}

}  // namespace handmap
