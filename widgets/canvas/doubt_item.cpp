#include "widgets/canvas/doubt_item.h"

#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <cmath>

#include "core/map/certainty.h"

namespace handmap {

namespace {

constexpr double kLeastPx = 2.0;  ///< a narrower edge is not seen
constexpr std::size_t kMostEdges = 400;
constexpr int kRings = 5;
constexpr int kRingAlpha = 9;
constexpr double kMarkPx = 14.0;
constexpr double kConeReach = 2.0;  // of the start's position σ
constexpr double kCone_m = 10.0;    // at least
constexpr int kConeSteps = 16;
constexpr int kStartAlpha = 18;

/// Of a wall: the place of the building and half of what its size is off.
double sigmaOfWall(const Uncertainty& uncertainty) {
  return std::hypot(uncertainty.position, uncertainty.size / 2.0);
}

}  // namespace

DoubtItem::DoubtItem(const MapDocument& document) : document_(document) {
  setFlag(ItemUsesExtendedStyleOption);  // for exposedRect
  follow(Touched::everything());
}

void DoubtItem::setColours(const Colours& colours) {
  colours_ = &colours;
  still_.forget();
  update();
}

void DoubtItem::follow(const Touched& touched) {
  prepareGeometryChange();
  still_.forget();
  update();
  const Map& map = document_.map();
  if (touched.onlyPlaces()) {
    // What was wider before stays in the bounds: they may be too wide.
    if (stateOf(map.layers, DrawingLayer::Buildings).hidden) return;
    for (const std::size_t place : touched.buildings) include(place);
    return;
  }
  around_start_ = {};
  buildings_ = {};
  reach_ = 0.0;
  any_may_not_exist_ = false;
  start_.reset();
  if (map.start && !stateOf(map.layers, DrawingLayer::Start).hidden) start_ = map.start_uncertainty;
  if (start_) {
    const double reach = std::max(kConeReach * start_->position, kCone_m);
    around_start_ = QRectF(map.start->x - reach, map.start->y - reach, 2.0 * reach, 2.0 * reach);
  }
  if (stateOf(map.layers, DrawingLayer::Buildings).hidden) return;
  for (std::size_t i = 0; i < map.buildings.size(); ++i) include(i);
}

void DoubtItem::include(std::size_t place) {
  const Building& building = document_.map().buildings[place];
  const Bounds& box = document_.buildingIndex().box(place);
  const Vec2 size = box.high - box.low;
  buildings_ |= QRectF(box.low.x(), box.low.y(), size.x(), size.y());
  for (const double sigma : sigmasOf(building)) reach_ = std::max(reach_, sigma);
  any_may_not_exist_ |= building.may_not_exist;
}

/// Of what a run has seen: the certainty that was won. Else what the drawing says of itself.
std::vector<double> DoubtItem::sigmasOf(const Building& building) const {
  std::vector<double> sigmas;
  if (isRecognised(building)) {
    for (const SideEstimate& wall : wallsOf(building)) sigmas.push_back(wall.sigma);
  } else {
    sigmas.assign(building.footprint().size(),
                  sigmaOfWall(document_.map().uncertaintyOf(building)));
  }
  return sigmas;
}

QRectF DoubtItem::boundingRect() const {
  if (buildings_.isNull()) return around_start_;
  return around_start_ | buildings_.adjusted(-reach_, -reach_, reach_, reach_);
}

/// Those in sight whose edges can be seen.
std::vector<DoubtItem::Edge> DoubtItem::edgesIn(const QRectF& exposed,
                                                double pixels_per_metre) const {
  const Map& map = document_.map();
  std::vector<Edge> edges;
  if (buildings_.isNull() || (reach_ * pixels_per_metre < kLeastPx && !any_may_not_exist_))
    return edges;
  const Bounds area{{exposed.left() - reach_, exposed.top() - reach_},
                    {exposed.right() + reach_, exposed.bottom() + reach_}};
  for (const std::size_t i : document_.buildingIndex().touching(area)) {
    const Building& building = map.buildings[i];
    Edge edge{{}, sigmasOf(building), building.may_not_exist};
    const bool is_soft =
        std::ranges::max(edge.sigmas) * pixels_per_metre >= kLeastPx || edge.may_not_exist;
    if (!is_soft || building.flags.hidden) continue;
    if (edges.size() == kMostEdges) return {};  // from so far away it would only be fog
    for (const Vec2& corner : building.footprint()) edge.outline << QPointF(corner.x(), corner.y());
    edges.push_back(std::move(edge));
  }
  return edges;
}

void DoubtItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  const QTransform to_device = painter->worldTransform();
  const QRect area = to_device.mapRect(option->exposedRect).toAlignedRect();
  painter->setWorldTransform({});
  still_.show(*painter, to_device, area, [&](QPainter& on_picture) {
    paintEdges(on_picture, to_device, option->exposedRect);
  });
  painter->setWorldTransform(to_device);
}

/// A soft circle for where it may be, and a cone for where it may look: one σ each.
void DoubtItem::paintStart(QPainter& painter, const QTransform& to_device) const {
  const auto& start = document_.map().start;
  if (!start_ || !start) return;
  QColor ink = (*colours_)[Role::Start];
  ink.setAlpha(kStartAlpha);
  painter.save();
  painter.setTransform(to_device, true);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  const QPointF at(start->x, start->y);
  for (int ring = 1; ring <= kRings; ++ring) {
    const double radius = start_->position * ring / kRings;
    painter.drawEllipse(at, radius, radius);
  }
  if (start_->heading > 0.0) {
    const double reach = std::max(kConeReach * start_->position, kCone_m);
    const double aside = std::min(start_->heading, kPi);
    QPolygonF cone{at};
    for (int step = -kConeSteps; step <= kConeSteps; ++step) {
      const double heading = start->heading + aside * step / kConeSteps;
      cone << at + reach * QPointF(std::cos(heading), std::sin(heading));
    }
    ink.setAlpha(2 * kStartAlpha);
    painter.setBrush(ink);
    painter.drawPolygon(cone);
  }
  ink.setAlpha(4 * kStartAlpha);
  QPen edge(ink, 1.0, Qt::DashLine);
  edge.setCosmetic(true);
  painter.setPen(edge);
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, start_->position, start_->position);
  painter.restore();
}

void DoubtItem::paintEdges(QPainter& painter, const QTransform& to_device,
                           const QRectF& exposed) const {
  const double pixels_per_metre = std::hypot(to_device.m11(), to_device.m12());
  const std::vector<Edge> seen = edgesIn(exposed, pixels_per_metre);
  paintStart(painter, to_device);
  painter.setBrush(Qt::NoBrush);
  QColor ink = (*colours_)[Role::Drawing];
  ink.setAlpha(kRingAlpha);
  for (const Edge& edge : seen) {
    const QPolygonF outline = to_device.map(edge.outline);
    const bool all_alike = std::ranges::all_of(
        edge.sigmas, [&edge](double sigma) { return sigma == edge.sigmas.front(); });
    for (int ring = 1; ring <= kRings; ++ring) {
      const auto pen_of = [&](double sigma) {
        return QPen(ink, 2.0 * sigma * pixels_per_metre * ring / kRings, Qt::SolidLine,
                    all_alike ? Qt::SquareCap : Qt::FlatCap, Qt::RoundJoin);
      };
      if (all_alike) {
        painter.setPen(pen_of(edge.sigmas.front()));
        painter.drawPolygon(outline);
        continue;
      }
      for (qsizetype wall = 0; wall < outline.size(); ++wall) {
        painter.setPen(pen_of(edge.sigmas[static_cast<std::size_t>(wall)]));
        painter.drawLine(outline[wall], outline[(wall + 1) % outline.size()]);
      }
    }
  }
  painter.setPen((*colours_)[Role::Doubtful]);
  QFont font = painter.font();
  font.setBold(true);
  painter.setFont(font);
  for (const Edge& edge : seen) {
    if (!edge.may_not_exist) continue;
    const QRectF on_device = to_device.map(edge.outline).boundingRect();
    painter.drawText(
        QRectF(on_device.right() - kMarkPx - 2.0, on_device.top() + 2.0, kMarkPx, kMarkPx + 2.0),
        Qt::AlignCenter, QStringLiteral("?"));
  }
}

}  // namespace handmap
