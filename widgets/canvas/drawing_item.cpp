#include "widgets/canvas/drawing_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <cmath>
#include <utility>

#include "core/geometry/inner_point.h"
#include "widgets/canvas/symbols.h"

namespace handmap {

namespace {

constexpr double kPenPx = 4.0;  ///< around what is drawn
constexpr double kDotPx = 3.0;  ///< smaller buildings are dots
constexpr double kDotOfManyPx = 8.0;
constexpr double kMarkedPx = 18.0;  ///< smaller buildings show no lock
constexpr double kNarrowestLetterPx = 3.5;
constexpr std::size_t kManyBuildings = 1000;  ///< at once: drawn as plain lines, in one go
constexpr qsizetype kManySelected = 100;

QPointF toScene(const Vec2& point) { return {point.x(), point.y()}; }

QPointF middleOf(const QPolygonF& outline) {
  Polygon corners;
  for (const QPointF& corner : outline) corners.emplace_back(corner.x(), corner.y());
  return toScene(innerPoint(corners));
}

/// Lines of one pixel are sharp when they run through the middle of pixels.
QPointF crisp(const QPointF& point) {
  return {std::floor(point.x()) + 0.5, std::floor(point.y()) + 0.5};
}

}  // namespace

DrawingItem::DrawingItem(const MapDocument& document) : document_(document) {
  setFlag(ItemUsesExtendedStyleOption);  // for exposedRect
  follow(Touched::everything());
}

void DrawingItem::setColours(const Colours& colours) {
  colours_ = &colours;
  forgetStills();
  update();
}

void DrawingItem::setRouteShown(bool shown) {
  route_shown_ = shown;
  update();
}

void DrawingItem::setLabelOutlines(const QHash<QString, QPolygonF>& outlines) {
  label_outlines_ = outlines;
  still_labels_.forget();
}

void DrawingItem::forgetStills() {
  still_.forget();
  still_labels_.forget();
}

bool DrawingItem::Shape::shows(const Building& building) const {
  return of == building.shape && id == building.id && name == building.name &&
         fixed == building.fixed && locked == building.flags.locked;
}

DrawingItem::Shape DrawingItem::shapeOf(const Building& building) const {
  Shape shape;
  shape.of = building.shape;
  shape.id = building.id;
  shape.name = building.name;
  shape.fixed = building.fixed;
  shape.locked = building.flags.locked;
  for (const Vec2& corner : building.footprint()) shape.outline << toScene(corner);
  shape.bounds = shape.outline.boundingRect();
  shape.selected = selected_.contains(QString::fromStdString(building.id));
  return shape;
}

void DrawingItem::follow(const Touched& touched) {
  const std::size_t count = document_.map().buildings.size();
  layers_ = document_.map().layers;
  if (touched.listed || touched.layers) {
    shapes_.resize(count);
    drawn_ = {};
    for (std::size_t i = 0; i < count; ++i) takeBuilding(i);
  } else {
    for (const std::size_t place : touched.buildings) takeBuilding(place);
  }
  if (touched.listed) {
    places_.clear();
    places_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) places_.emplace(shapes_[i].id, i);
  }
  reselect();
  showPreviewed();
}

void DrawingItem::takeBuilding(std::size_t place) {
  const Building& building = document_.map().buildings[place];
  Shape& shape = shapes_[place];
  if (!shape.shows(building)) shape = shapeOf(building);
  shape.off = layer(DrawingLayer::Buildings).hidden || building.flags.hidden;
  if (!shape.off) drawn_ |= shape.bounds;
}

void DrawingItem::reselect() {
  const auto mark = [&](bool selected) {
    for (const QString& key : std::as_const(selected_)) {
      const auto place = places_.find(key.toStdString());
      if (place != places_.end()) shapes_[place->second].selected = selected;
    }
  };
  mark(false);
  const QStringList keys = document_.selection();
  selected_ = QSet<QString>(keys.begin(), keys.end());
  mark(true);
  forgetStills();
  update();
}

void DrawingItem::setPreview(const MapChange* preview) {
  if (!preview && preview_.isEmpty()) return;
  const MapChange before = std::exchange(preview_, preview != nullptr ? *preview : MapChange());
  if (!std::ranges::equal(before.buildings, preview_.buildings, {}, &Building::id, &Building::id)) {
    for (const Building& building : before.buildings) hide(building.id, false);
    forgetStills();
  }
  showPreviewed();
}

void DrawingItem::hide(const std::string& id, bool hidden) {
  if (const auto place = places_.find(id); place != places_.end())
    shapes_[place->second].hidden = hidden;
}

void DrawingItem::showPreviewed() {
  previewed_.clear();
  for (const Building& building : preview_.buildings) {
    previewed_.push_back(shapeOf(building));
    hide(building.id, true);
  }
  updateBounds();
  update();
}

void DrawingItem::updateBounds() {
  prepareGeometryChange();
  const Map& map = document_.map();
  bounds_ = drawn_;
  const auto include = [&](const QRectF& box) { bounds_ = bounds_ | box; };
  const auto include_point = [&](const Vec2& point) {
    include(QRectF(toScene(point), QSizeF()).adjusted(-1.0, -1.0, 1.0, 1.0));
  };
  for (const Shape& shape : previewed_) include(shape.bounds);
  for (const Landmark& landmark : map.landmarks) include_point(landmark.position);
  for (const Landmark& landmark : preview_.landmarks) include_point(landmark.position);
  for (const auto& start : {map.start, preview_.start})
    if (start) include_point(start->position());
  for (const Vec2& point : preview_.route.value_or(map.route)) include_point(point);
}

void DrawingItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const QTransform to_device = painter->worldTransform();
  const QRectF exposed = option->exposedRect;
  painter->save();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  const QRectF still = to_device.mapRect(exposed & drawn_);
  const double opacity = layer(DrawingLayer::Buildings).opacity;
  if (!still.isEmpty())
    still_.show(*painter, to_device,
                still.adjusted(-kPenPx, -kPenPx, kPenPx, kPenPx).toAlignedRect(),
                [&](QPainter& on_picture) {
                  on_picture.setOpacity(opacity);
                  paintBuildings(on_picture, visible(exposed), to_device);
                });
  painter->setOpacity(opacity);
  paintBuildings(*painter, previewedIn(exposed), to_device);
  paintSigns(*painter, to_device);
  painter->restore();
}

DrawingItem::Shapes DrawingItem::visible(const QRectF& exposed) const {
  Shapes shapes;
  const Bounds area{{exposed.left(), exposed.top()}, {exposed.right(), exposed.bottom()}};
  for (const std::size_t i : document_.buildingIndex().touching(area))
    if (i < shapes_.size() && !shapes_[i].hidden && !shapes_[i].off) shapes.push_back(&shapes_[i]);
  return shapes;
}

DrawingItem::Shapes DrawingItem::previewedIn(const QRectF& exposed) const {
  Shapes shapes;
  for (const Shape& shape : previewed_)
    if (shape.bounds.intersects(exposed)) shapes.push_back(&shape);
  return shapes;
}

void DrawingItem::paintBuildings(QPainter& painter, const Shapes& shapes,
                                 const QTransform& to_device) const {
  const bool many = shapes.size() > kManyBuildings;
  const double dot = (many ? kDotOfManyPx : kDotPx) / std::hypot(to_device.m11(), to_device.m12());
  for (const bool selected : {false, true}) {
    const Role role = selected ? Role::Selection : Role::Drawing;
    QPen pen = colours_->pen(role);
    QList<QRectF> dots;
    QList<QLineF> walls;
    QList<QPolygonF> outlines;
    for (const Shape* shape : shapes) {
      if (shape->selected != selected) continue;
      if (std::max(shape->bounds.width(), shape->bounds.height()) < dot) {
        const QPointF a = to_device.map(shape->bounds.topLeft());
        const QPointF b = to_device.map(shape->bounds.bottomRight());
        dots << QRectF(a, b).normalized().adjusted(-0.5, -0.5, 0.5, 0.5);
      } else if (many) {
        QPointF from = to_device.map(shape->outline.constLast());
        for (const QPointF& corner : shape->outline) {
          const QPointF to = to_device.map(corner);
          walls << QLineF(from, to);
          from = to;
        }
      } else {
        outlines << to_device.map(shape->outline);
        std::ranges::transform(outlines.last(), outlines.last().begin(), crisp);
      }
    }
    // The outline hides the steps at the edge of the ground.
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(Qt::NoPen);
    painter.setBrush(pen.color());
    painter.drawRects(dots);
    painter.setBrush(colours_->brush(role));
    for (const QPolygonF& outline : outlines) painter.drawPolygon(outline);
    pen.setWidthF(many ? 0.0 : pen.widthF());
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawLines(walls);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!document_.map().underlays.empty()) {
      painter.setPen(colours_->casing(pen));
      for (const QPolygonF& outline : outlines) painter.drawPolygon(outline);
      painter.setPen(pen);
    }
    for (const QPolygonF& outline : outlines) painter.drawPolygon(outline);
  }
}

void DrawingItem::paintLabels(QPainter& painter, const QTransform& to_device,
                              const QRectF& exposed) const {
  paintLandmarkLabels(painter, to_device);
  still_labels_.show(painter, to_device, to_device.mapRect(exposed).toAlignedRect(),
                     [&](QPainter& on_picture) {
                       on_picture.setRenderHint(QPainter::Antialiasing);
                       paintLabels(on_picture, visible(exposed), to_device);
                     });
  paintLabels(painter, previewedIn(exposed), to_device);
}

void DrawingItem::paintLabels(QPainter& painter, const Shapes& shapes,
                              const QTransform& to_device) const {
  const double scale = std::hypot(to_device.m11(), to_device.m12());
  const double line = painter.fontMetrics().height();
  for (const Shape* shape : shapes) {
    const double size = std::max(shape->bounds.width(), shape->bounds.height()) * scale;
    if (size >= line || shape->selected) paintLabel(painter, *shape, to_device);
  }
}

void DrawingItem::paintLabel(QPainter& painter, const Shape& shape,
                             const QTransform& to_device) const {
  const double line = painter.fontMetrics().height();
  bool on_ground = !document_.map().underlays.empty();
  QPolygonF outline = to_device.map(shape.outline);
  if (!shape.middle) shape.middle = middleOf(shape.outline);
  QPointF centre = to_device.map(*shape.middle);
  const QString id = QString::fromStdString(shape.id);
  // What the tool moves is where its preview is.
  const auto other = label_outlines_.constFind(id);
  if (other != label_outlines_.cend() && previewed_.empty()) {
    outline = to_device.map(*other);
    centre = middleOf(outline);
    on_ground = true;  // an arrow may end there
  }
  const QRectF bounds = outline.boundingRect();
  const QString name = QString::fromStdString(shape.name);
  const auto fits = [&](const QString& text, int lines) {
    if (text.isEmpty() || bounds.width() < kNarrowestLetterPx * static_cast<double>(text.size()) ||
        bounds.height() < lines * line)
      return false;
    const double width = painter.fontMetrics().horizontalAdvance(text) + 6.0;
    QPolygonF label(QRectF(0.0, 0.0, width, lines * line)
                        .translated(centre - QPointF(width / 2.0, lines * line / 2.0)));
    return std::ranges::all_of(label, [&](const QPointF& corner) {
      return outline.containsPoint(corner, Qt::OddEvenFill);
    });
  };
  const QPointF half_line(0.0, line / 2.0);
  const auto write = [&](const QPointF& at, const QString& text, bool ground) {
    handmap::paintLabel(painter, at, text, *colours_, ground);
  };
  if (fits(name, 2)) {
    write(centre - half_line, name, on_ground);
    write(centre + half_line, id, on_ground);
  } else if (fits(name, 1)) {
    write(centre, name, on_ground);
  } else if (fits(id, 1)) {
    write(centre, id, on_ground);
  } else if (shape.selected && selected_.size() < kManySelected) {
    write(QPointF(centre.x(), bounds.bottom() + line), id, true);
  }
  if (std::min(bounds.width(), bounds.height()) < kMarkedPx) return;
  QPointF mark = bounds.topLeft() + QPointF(11.0, 11.0);
  if (shape.locked) {
    paintLockSymbol(painter, mark, (*colours_)[Role::Drawing]);
    mark += QPointF(14.0, 0.0);
  }
  if (shape.fixed) paintFixedSymbol(painter, mark, (*colours_)[Role::Drawing]);
}

const Landmark& DrawingItem::shown(const Landmark& on_map) const {
  const auto moved = std::ranges::find(preview_.landmarks, on_map.id, &Landmark::id);
  return moved == preview_.landmarks.end() ? on_map : *moved;
}

void DrawingItem::paintLandmarkLabels(QPainter& painter, const QTransform& to_device) const {
  if (layer(DrawingLayer::Landmarks).hidden) return;
  for (const Landmark& on_map : document_.map().landmarks) {
    if (on_map.flags.hidden) continue;
    const Landmark& landmark = shown(on_map);
    const QString text =
        QString::fromStdString(landmark.name.empty() ? landmark.id : landmark.name);
    const int width = painter.fontMetrics().horizontalAdvance(text);
    handmap::paintLabel(
        painter, to_device.map(toScene(landmark.position)) + QPointF(12.0 + width / 2.0, 0.0), text,
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
  const bool route_shown = route_shown_ || preview_.route || selected_.contains(kRouteKey);
  if (route_shown && !route.isEmpty() && !layer(DrawingLayer::Route).hidden)
    paintRoute(painter, route, route_pen, ground);

  painter.setOpacity(layer(DrawingLayer::Landmarks).opacity);
  for (const Landmark& landmark : map.landmarks) {
    if (layer(DrawingLayer::Landmarks).hidden || landmark.flags.hidden) continue;
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
