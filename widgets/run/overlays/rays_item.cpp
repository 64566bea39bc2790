#include "widgets/run/overlays/rays_item.h"

#include <QPainter>

#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr std::size_t kMostRays = 2000;  // more only hide the rest

}  // namespace

void RaysItem::setColours(const Colours& colours) {
  colours_ = &colours;
  update();
}

void RaysItem::setStory(const WallStory* story, std::optional<std::size_t> chosen) {
  prepareGeometryChange();
  others_.clear();
  chosen_.clear();
  returns_.clear();
  wall_ = {};
  bounds_ = {};
  if (story == nullptr) return;
  wall_ = {toScene(story->wall.a), toScene(story->wall.b)};
  const std::size_t every = 1 + story->rays / kMostRays;
  std::size_t ray = 0;
  for (std::size_t i = 0; i < story->witnesses.size(); ++i) {
    const WallWitness& witness = story->witnesses[i];
    QList<QLineF>& lines = chosen == i ? chosen_ : others_;
    for (const Vec2& end : witness.returns) {
      returns_ << toScene(end);
      if (chosen != i && ray++ % every != 0) continue;
      lines << QLineF(toScene(witness.pose.position()), toScene(end));
      bounds_ |= QRectF(lines.back().p1(), lines.back().p2()).normalized();
    }
  }
  bounds_ |= returns_.boundingRect() | QRectF(wall_.p1(), wall_.p2()).normalized();
  bounds_.adjust(-2.0, -2.0, 2.0, 2.0);
}

void RaysItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  const QColor ink = (*colours_)[Role::LocalMap];
  QColor faint = ink;
  faint.setAlpha(60);
  painter->setPen(cosmeticPen(faint, 1.0));
  painter->drawLines(others_);
  painter->setPen(cosmeticPen(ink, 1.0));
  painter->drawLines(chosen_);
  QPen dot = cosmeticPen(ink, 3.0);
  dot.setCapStyle(Qt::RoundCap);
  painter->setPen(dot);
  painter->drawPoints(returns_);
  painter->setPen(cosmeticPen((*colours_)[Role::Selection], 4.0));
  painter->drawLine(wall_);
}

}  // namespace handmap
