#include "widgets/run/overlays/building_hints.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>

#include "widgets/canvas/map_canvas.h"
#include "widgets/run/overlays/run_overlays.h"
#include "widgets/run/words/words.h"

namespace handmap {

namespace {

constexpr double kNearPx = 7.0;

}  // namespace

BuildingHints::BuildingHints(MapCanvas& canvas, const RunOverlays& overlays, QObject* parent)
    : QObject(parent), canvas_(canvas), overlays_(overlays) {
  canvas_.viewport()->installEventFilter(this);
}

bool BuildingHints::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto& help = static_cast<QHelpEvent&>(*event);
    const QString words = wordsAt(help.pos());
    if (!words.isEmpty()) {
      QToolTip::showText(help.globalPos(), words, canvas_.viewport());
      return true;
    }
  } else if (event->type() == QEvent::MouseButtonPress) {
    const auto& press = static_cast<QMouseEvent&>(*event);
    if (press.button() == Qt::LeftButton && canvas_.tool() == ToolId::Select) {
      click(press.position());
    }
  }
  return QObject::eventFilter(watched, event);
}

std::optional<std::size_t> BuildingHints::indexAt(const Vec2& metres) const {
  const Map* map = overlays_.shownMap();
  if (map == nullptr || !overlays_.isShown(Layer::Corrected)) return std::nullopt;
  const std::size_t count = std::min(map->buildings.size(), overlays_.drawing().buildings.size());
  for (std::size_t b = 0; b < count; ++b)
    if (map->buildings[b].estimate && contains(map->buildings[b].footprint(), metres)) return b;
  return std::nullopt;
}

QString BuildingHints::buildingAt(const Vec2& metres) const {
  const auto index = indexAt(metres);
  return index ? QString::fromStdString(overlays_.shownMap()->buildings[*index].id) : QString();
}

QString BuildingHints::wordsAt(QPointF viewport_position) const {
  const QPointF metres = canvas_.viewportTransform().inverted().map(viewport_position);
  const auto index = indexAt({metres.x(), metres.y()});
  if (!index) return {};
  const Map& drawing = overlays_.drawing();
  const auto& truth = overlays_.trueMiddles();
  return Words::building(drawing, *overlays_.shownMap(), *index, truth ? &*truth : nullptr);
}

void BuildingHints::click(QPointF viewport_position) {
  const Map* map = overlays_.shownMap();
  if (map == nullptr) return;
  const QPointF metres = canvas_.viewportTransform().inverted().map(viewport_position);
  const Vec2 at(metres.x(), metres.y());
  double nearest = kNearPx / canvas_.pixelsPerMetre();
  std::optional<std::pair<std::size_t, std::size_t>> hit;
  for (std::size_t b = 0; b < map->buildings.size(); ++b) {
    if (!map->buildings[b].estimate) continue;
    const Polygon outline = map->buildings[b].footprint();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double distance =
          distanceTo(Segment{outline[i], outline[(i + 1) % outline.size()]}, at);
      if (distance >= nearest) continue;
      nearest = distance;
      hit = {b, i};
    }
  }
  if (hit) Q_EMIT wallClicked(hit->first, hit->second);
}

}  // namespace handmap
