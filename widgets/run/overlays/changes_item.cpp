#include "widgets/run/overlays/changes_item.h"

#include <QPainter>

#include "core/geometry/inner_point.h"
#include "widgets/canvas/symbols.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr double kLabelPx = 20.0;         // around the end: the name of the building
constexpr double kLeastPx = 40.0;         // shorter arrows would be a blot in the name
constexpr double kLeastForTextPx = 14.0;  // shorter ones have no words: zoom in to read them
constexpr double kMarginM = 20.0;         // room for words when zoomed out far
constexpr double kMostLines = 2.0;        // of a name

/// The name of the building at its end stays free.
QLineF shortened(QLineF line) {
  line.setLength(std::max(0.6 * line.length(), line.length() - kLabelPx));
  return line;
}

/// Below the name, or below the building where that leaves no room.
QPointF belowName(const QPointF& middle, const QRectF& building, double line_height) {
  const double below = middle.y() + 0.5 * (kMostLines + 1.0) * line_height;
  const bool has_room = below + line_height < building.bottom();
  return {middle.x(), has_room ? below : building.bottom() + 0.75 * line_height};
}

}  // namespace

void ChangesItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void ChangesItem::clear() {
  prepareGeometryChange();
  arrows_.clear();
  bounds_ = {};
}

void ChangesItem::setChanges(const Map& drawing, const Map& refined) {
  clear();
  for (const BuildingChange& change : changesOf(drawing, refined).moved) {
    // Inside, also of an L, whose middle is not.
    const Vec2 from = innerPoint(drawing.buildings[change.building].footprint());
    const Polygon outline = refined.buildings[change.building].footprint();
    arrows_.push_back({{toScene(from), toScene(Vec2(from + change.now - change.drawn))},
                       tr("moved %1 m").arg(change.moved_m(), 0, 'f', 1),
                       toScene(outline).boundingRect()});
    bounds_ |= QRectF(arrows_.back().line.p1(), arrows_.back().line.p2()).normalized();
  }
  if (!arrows_.empty()) bounds_.adjust(-kMarginM, -kMarginM, kMarginM, kMarginM);
}

void ChangesItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(cosmeticPen((*colours_)[Role::Corrected], 1.6));
  for (const Arrow& arrow : arrows_) {
    const QLineF line = to_device.map(arrow.line);
    if (line.length() >= kLeastPx) paintArrow(*painter, shortened(line));
  }
  const double height = painter->fontMetrics().height();
  for (const Arrow& arrow : arrows_) {
    const QLineF line = to_device.map(arrow.line);
    if (line.length() < kLeastForTextPx) continue;
    const QPointF at = belowName(line.p2(), to_device.mapRect(arrow.bounds), height);
    paintLabel(*painter, at, arrow.text, *colours_, true);
  }
  painter->restore();
}

}  // namespace handmap
