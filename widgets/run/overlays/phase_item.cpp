#include "widgets/run/overlays/phase_item.h"

#include <QPainter>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

QList<QLineF> linesOf(const std::vector<Segment>& segments) {
  QList<QLineF> lines;
  for (const Segment& segment : segments) lines << QLineF(toScene(segment.a), toScene(segment.b));
  return lines;
}

}  // namespace

void PhaseItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void PhaseItem::setPhase(const Phase* phase) {
  prepareGeometryChange();
  walls_ = phase ? linesOf(phase->walls) : QList<QLineF>();
  links_ = phase ? linesOf(phase->links) : QList<QLineF>();
  outlines_ = {};
  if (phase) {
    for (const Polygon& outline : phase->outlines) {
      outlines_.addPolygon(toScene(outline));
      outlines_.closeSubpath();
    }
  }
  bounds_ = outlines_.controlPointRect();
  for (const QList<QLineF>& lines : {walls_, links_}) {
    for (const QLineF& line : lines) bounds_ |= QRectF(line.p1(), line.p2()).normalized();
  }
  bounds_.adjust(-2.0, -2.0, 2.0, 2.0);
}

void PhaseItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  QPen pen = cosmeticPen((*colours_)[Role::LocalMap], 3.0);
  pen.setCapStyle(Qt::RoundCap);
  painter->setPen(pen);
  painter->drawLines(walls_);
  painter->strokePath(outlines_, colours_->pen(Role::Preview));
  pen = colours_->pen(Role::Preview);
  pen.setStyle(Qt::DotLine);
  painter->setPen(pen);
  painter->drawLines(links_);
}

}  // namespace handmap
