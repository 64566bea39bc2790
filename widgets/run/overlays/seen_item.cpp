#include "widgets/run/overlays/seen_item.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr std::size_t kMostPoints = 20'000;  // more only hide the rest
constexpr float kSureWall = 0.5F;
constexpr double kBetweenRays = toRadians(4.0);  // a wider gap was not looked through
constexpr double kMargin_m = 2.0;

QPointF endOf(const Ray& ray) {
  const double bearing = static_cast<double>(ray.bearing);
  const double range = static_cast<double>(ray.range);
  return {range * std::cos(bearing), range * std::sin(bearing)};
}

/// From the robot to the ends of the rays and back wherever no ray went.
QPolygonF lookedThrough(const Scan& scan) {
  QPolygonF area;
  for (std::size_t i = 0; i < scan.rays.size(); ++i) {
    const Ray& ray = scan.rays[i];
    const Ray& before = scan.rays[i == 0 ? scan.rays.size() - 1 : i - 1];
    double gap = static_cast<double>(ray.bearing) - static_cast<double>(before.bearing);
    if (gap < 0.0) gap += 2.0 * kPi;
    if (gap > kBetweenRays) area << QPointF();
    area << endOf(ray);
  }
  return area;
}

}  // namespace

void SeenItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void SeenItem::setSeen(std::shared_ptr<const Perceived> seen, const Pose2& robot, double range_m) {
  prepareGeometryChange();
  walls_seen_.clear();
  others_.clear();
  looked_through_.clear();
  seen_ = std::move(seen);
  range_m_ = seen_ ? range_m : 0.0;
  const double half = range_m_ > 0.0 ? range_m_ + kMargin_m : 0.0;
  bounds_ = {-half, -half, 2.0 * half, 2.0 * half};
  setPos(robot.x, robot.y);
  setRotation(toDegrees(robot.heading));
}

void SeenItem::setWalls(const std::vector<SeenWall>& walls) {
  prepareGeometryChange();
  walls_.clear();
  bounds_ = {};
  for (const SeenWall& wall : walls) {
    walls_ << QLineF(toScene(wall.piece.a), toScene(wall.piece.b));
    bounds_ |= QRectF(walls_.back().p1(), walls_.back().p2()).normalized();
  }
  bounds_.adjust(-kMargin_m, -kMargin_m, kMargin_m, kMargin_m);
}

QPen SeenItem::wallPen(const Colours& colours) {
  QColor colour = colours[Role::LocalMap];
  colour.setAlpha(200);
  QPen pen = cosmeticPen(colour, 5.0);
  pen.setCapStyle(Qt::RoundCap);
  return pen;
}

QPen SeenItem::rangePen(const Colours& colours) {
  QPen pen = cosmeticPen(colours[Role::LocalMap], 1.0);
  pen.setStyle(Qt::DashDotLine);
  return pen;
}

QBrush SeenItem::sightBrush(const Colours& colours) {
  QColor colour = colours[Role::LocalMap];
  colour.setAlpha(22);
  return colour;
}

void SeenItem::prepare() {
  const std::shared_ptr<const Perceived> seen = std::exchange(seen_, nullptr);
  if (!seen) return;
  if (part_ == Part::Sight) {
    looked_through_ = lookedThrough(seen->percept.scan);
    return;
  }
  const std::vector<RangePoint>& points = seen->percept.points;
  const auto far_m = static_cast<float>(range_m_);
  const std::size_t every = 1 + points.size() / kMostPoints;
  for (std::size_t i = 0; i < points.size(); i += every) {
    const RangePoint& point = points[i];
    if (!(std::hypot(point.x, point.y) < far_m)) continue;
    others_ << QPointF(static_cast<double>(point.x), static_cast<double>(point.y));
  }
  for (const Ray& ray : seen->percept.scan.rays) {
    if (!ray.returned) continue;
    (ray.wall >= kSureWall ? walls_seen_ : others_) << endOf(ray);
  }
}

void SeenItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  prepare();
  if (part_ == Part::Points) return paintPoints(*painter);
  painter->setRenderHint(QPainter::Antialiasing);
  if (part_ == Part::Sight) return paintSight(*painter);
  painter->setPen(wallPen(*colours_));
  painter->drawLines(walls_);
}

void SeenItem::paintPoints(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing, false);
  QPen pen((*colours_)[Role::LocalMap], 1.0);  // wider ones take many times as long
  pen.setCosmetic(true);
  painter.setPen(pen);
  painter.drawPoints(others_);
  painter.setPen(cosmeticPen(pen.color(), 4.0));
  painter.drawPoints(walls_seen_);
}

void SeenItem::paintSight(QPainter& painter) const {
  painter.setRenderHint(QPainter::Antialiasing, false);  // nobody sees it, and it takes long
  painter.setPen(Qt::NoPen);
  painter.setBrush(sightBrush(*colours_));
  painter.drawPolygon(looked_through_);
  painter.setRenderHint(QPainter::Antialiasing);
  if (range_m_ <= 0.0) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(rangePen(*colours_));
  painter.drawEllipse(QPointF(), range_m_, range_m_);
}

}  // namespace handmap
