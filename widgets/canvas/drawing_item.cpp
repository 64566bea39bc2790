#include "widgets/canvas/drawing_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <cmath>

#include "core/map/map_flags.h"
#include "widgets/canvas/symbols.h"

namespace handmap {

namespace {

constexpr double kDotPx = 3.0;      ///< smaller buildings are dots
constexpr double kMarkedPx = 18.0;  ///< smaller buildings show no lock
constexpr double kNarrowestLetterPx = 3.5;
constexpr std::size_t kManyBuildings = 1000;
constexpr qsizetype kManySelected = 100;

bool isLarge(const QRectF& bounds) { return std::max(bounds.width(), bounds.height()) >= kDotPx; }

QPointF toScene(const Vec2& point) { return {point.x(), point.y()}; }

QPointF middleOf(const QPolygonF& outline) {
  Polygon corners;
  for (const QPointF& corner : outline) corners.emplace_back(corner.x(), corner.y());
  return toScene(centroid(corners));
}

/// Lines of one pixel are sharp when they run through the middle of pixels.
QPointF crisp(const QPointF& point) {
  return {std::floor(point.x()) + 0.5, std::floor(point.y()) + 0.5};
}

}  // namespace

DrawingItem::DrawingItem(const MapDocument& document) : document_(document) {
  setFlag(ItemUsesExtendedStyleOption);  // for exposedRect
  rebuild();
}

void DrawingItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

DrawingItem::Shape DrawingItem::shapeOf(const Building& building) const {
  Shape shape;
  const Polygon footprint = building.footprint();
  for (const Vec2& corner : footprint) shape.outline << toScene(corner);
  shape.bounds = shape.outline.boundingRect();
  shape.middle = toScene(centroid(footprint));
  shape.id = QString::fromStdString(building.id);
  shape.name = QString::fromStdString(building.name);
  shape.fixed = building.fixed;
  shape.selected = selected_.contains(shape.id);
  return shape;
}

void DrawingItem::rebuild() {
  const QStringList keys = document_.selection();
  selected_ = QSet<QString>(keys.begin(), keys.end());
  shapes_.clear();
  places_.clear();
  shapes_.reserve(document_.map().buildings.size());
  layers_ = layersOf(document_.map());
  for (const Building& building : document_.map().buildings) {
    if (layer(DrawingLayer::Buildings).hidden || isHidden(building)) continue;
    shapes_.push_back(shapeOf(building));
    places_.insert(shapes_.back().id, shapes_.size() - 1);
  }
  const MapChange preview = preview_;
  setPreview(&preview);
}

void DrawingItem::setPreview(const MapChange* preview) {
  for (const Shape& shape : previewed_)
    if (const auto place = places_.constFind(shape.id); place != places_.cend())
      shapes_[*place].hidden = false;
  previewed_.clear();
  preview_ = preview ? *preview : MapChange();
  for (const Building& building : preview_.buildings) {
    previewed_.push_back(shapeOf(building));
    if (const auto place = places_.constFind(previewed_.back().id); place != places_.cend())
      shapes_[*place].hidden = true;
  }
  updateBounds();
  update();
}

void DrawingItem::updateBounds() {
  prepareGeometryChange();
  const Map& map = document_.map();
  bounds_ = {};
  const auto include = [&](const QRectF& box) { bounds_ = bounds_ | box; };
  const auto include_point = [&](const Vec2& point) {
    include(QRectF(toScene(point), QSizeF()).adjusted(-1.0, -1.0, 1.0, 1.0));
  };
  for (const Shape& shape : shapes_) include(shape.bounds);
  for (const Shape& shape : previewed_) include(shape.bounds);
  for (const Landmark& landmark : map.landmarks) include_point(landmark.position);
  for (const Landmark& landmark : preview_.landmarks) include_point(landmark.position);
  for (const auto& start : {map.start, preview_.start})
    if (start) include_point(start->position());
  for (const Vec2& point : preview_.route.value_or(map.route)) include_point(point);
}

void DrawingItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const QTransform to_device = painter->worldTransform();
  painter->save();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  const std::vector<Placed> placed = place(to_device, option->exposedRect);
  painter->setOpacity(layer(DrawingLayer::Buildings).opacity);
  paintBuildings(*painter, placed);
  paintSigns(*painter, to_device);
  painter->restore();
}

std::vector<DrawingItem::Placed> DrawingItem::place(const QTransform& to_device,
                                                    const QRectF& exposed) const {
  std::vector<Placed> placed;
  for (const auto* shapes : {&shapes_, &previewed_}) {
    for (const Shape& shape : *shapes) {
      if (shape.hidden || !shape.bounds.intersects(exposed)) continue;
      QPolygonF outline = to_device.map(shape.outline);
      std::ranges::transform(outline, outline.begin(), crisp);
      placed.push_back({&shape, outline, outline.boundingRect()});
    }
  }
  return placed;
}

void DrawingItem::paintBuildings(QPainter& painter, const std::vector<Placed>& placed) const {
  for (const bool selected : {false, true}) {
    const Role role = selected ? Role::Selection : Role::Drawing;
    QPen pen = colours_->pen(role);
    if (placed.size() > kManyBuildings) pen.setWidthF(1.0);  // ten times as fast
    const auto paint_all = [&](auto paint_one) {
      for (const Placed& building : placed)
        if (building.shape->selected == selected) paint_one(building);
    };
    // The outline hides the steps at the edge of the ground.
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours_->brush(role));
    paint_all([&](const Placed& building) {
      if (isLarge(building.bounds)) painter.drawPolygon(building.outline);
    });
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    paint_all([&](const Placed& building) {
      if (isLarge(building.bounds))
        painter.drawPolygon(building.outline);
      else
        painter.fillRect(building.bounds.adjusted(-0.5, -0.5, 0.5, 0.5), pen.color());
    });
  }
}

void DrawingItem::paintLabels(QPainter& painter, const QTransform& to_device,
                              const QRectF& exposed) const {
  paintLandmarkLabels(painter, to_device);
  const std::vector<Placed> placed = place(to_device, exposed);
  const double line = painter.fontMetrics().height();
  for (const Placed& drawn : placed) {
    bool on_ground = !document_.map().underlays.empty();
    const Shape* shape = drawn.shape;
    QPolygonF outline = drawn.outline;
    QPointF centre = to_device.map(shape->middle);
    // What the tool moves is where its preview is.
    const auto other = label_outlines_.constFind(shape->id);
    if (other != label_outlines_.cend() && previewed_.empty()) {
      outline = to_device.map(*other);
      centre = middleOf(outline);
      on_ground = true;  // an arrow may end there
    }
    const QRectF bounds = outline.boundingRect();
    const auto fits = [&, &at = outline, &box = bounds](const QString& text, int lines) {
      if (text.isEmpty() || box.width() < kNarrowestLetterPx * static_cast<double>(text.size()) ||
          box.height() < lines * line)
        return false;
      const double width = painter.fontMetrics().horizontalAdvance(text) + 6.0;
      QPolygonF label(QRectF(0.0, 0.0, width, lines * line)
                          .translated(centre - QPointF(width / 2.0, lines * line / 2.0)));
      return std::ranges::all_of(
          label, [&](const QPointF& corner) { return at.containsPoint(corner, Qt::OddEvenFill); });
    };
    const QPointF half_line(0.0, line / 2.0);
    if (fits(shape->name, 2)) {
      paintLabel(painter, centre - half_line, shape->name, *colours_, on_ground);
      paintLabel(painter, centre + half_line, shape->id, *colours_, on_ground);
    } else if (fits(shape->name, 1)) {
      paintLabel(painter, centre, shape->name, *colours_, on_ground);
    } else if (fits(shape->id, 1)) {
      paintLabel(painter, centre, shape->id, *colours_, on_ground);
    } else if (shape->selected && selected_.size() < kManySelected) {
      paintLabel(painter, QPointF(centre.x(), bounds.bottom() + line), shape->id, *colours_, true);
    }
    if (shape->fixed && std::min(bounds.width(), bounds.height()) >= kMarkedPx)
      paintFixedSymbol(painter, bounds.topLeft() + QPointF(11.0, 11.0), (*colours_)[Role::Drawing]);
  }
}

const Landmark& DrawingItem::shown(const Landmark& on_map) const {
  const auto moved = std::ranges::find(preview_.landmarks, on_map.id, &Landmark::id);
  return moved == preview_.landmarks.end() ? on_map : *moved;
}

void DrawingItem::paintLandmarkLabels(QPainter& painter, const QTransform& to_device) const {
  if (layer(DrawingLayer::Landmarks).hidden) return;
  for (const Landmark& on_map : document_.map().landmarks) {
    if (isHidden(on_map)) continue;
    const Landmark& landmark = shown(on_map);
    const QString text =
        QString::fromStdString(landmark.name.empty() ? landmark.id : landmark.name);
    const int width = painter.fontMetrics().horizontalAdvance(text);
    paintLabel(painter,
               to_device.map(toScene(landmark.position)) + QPointF(12.0 + width / 2.0, 0.0), text,
               *colours_, true);
  }
}

void DrawingItem::paintSigns(QPainter& painter, const QTransform& to_device) const {
  const Map& map = document_.map();
  const auto device = [&](const Vec2& point) { return to_device.map(toScene(point)); };
  const auto ink = [&](const QString& key, Role role) {
    return (*colours_)[selected_.contains(key) ? Role::Selection : role];
  };
  const QColor ground = (*colours_)[Role::Background];

  QPolygonF route;
  for (const Vec2& point : preview_.route ? *preview_.route : map.route) route << device(point);
  QPen route_pen = colours_->pen(Role::Route);
  route_pen.setColor(ink(kRouteKey, Role::Route));
  painter.setOpacity(layer(DrawingLayer::Route).opacity);
  if (!route.isEmpty() && !layer(DrawingLayer::Route).hidden)
    paintRoute(painter, route, route_pen, ground);

  painter.setOpacity(layer(DrawingLayer::Landmarks).opacity);
  for (const Landmark& landmark : map.landmarks) {
    if (layer(DrawingLayer::Landmarks).hidden || isHidden(landmark)) continue;
    const QString id = QString::fromStdString(landmark.id);
    paintLandmarkSymbol(painter, device(shown(landmark).position), ink(id, Role::Landmark), ground);
  }

  if (layer(DrawingLayer::Start).hidden) return;
  painter.setOpacity(layer(DrawingLayer::Start).opacity);
  if (const auto& start = preview_.start ? preview_.start : map.start) {
    const QPointF at = device(start->position());
    const QPointF ahead = device(start->position() + unitVector(start->heading)) - at;
    paintStartSymbol(painter, at, ahead, ink(kStartKey, Role::Start), ground);
  }
}

}  // namespace handmap
