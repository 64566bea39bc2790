#include "widgets/canvas/tools/drags.h"

#include "widgets/canvas/tools/building_handles.h"

namespace handmap {

namespace {

constexpr double kReachPx = 8.0;
constexpr double kStartHandlePx = 38.0;

/// Free turns are rounded to tidy numbers, held ones to steps one can see.
double turnStep(Qt::KeyboardModifiers modifiers) {
  return modifiers & (Qt::ShiftModifier | Qt::ControlModifier) ? 15.0 : 0.5;
}

bool isNear(const Vec2& handle, const ToolEvent& event) {
  return (handle - event.position).norm() <= kReachPx * event.metres_per_pixel;
}

std::optional<Drag> buildingDrag(const MapDocument& document, const ToolEvent& press) {
  const Building* building = onlyBuilding(document);
  if (!building) return std::nullopt;
  const Rectangle box = building->box();
  const auto handle = handleAt(box, press.position, press.metres_per_pixel);
  if (!handle) return std::nullopt;
  const QString name = displayName(document.map(), document.selection().constFirst());
  if (handle->turns())
    return Drag{[building = *building, box](const ToolEvent& event) {
                  const Rectangle target = turned(box, event.position, turnStep(event.modifiers));
                  return MapChange{.buildings = {building.fitted(target)}};
                },
                QObject::tr("Turn %1").arg(name), Readout::Heading};
  return Drag{[building = *building, box, handle = *handle](const ToolEvent& event) {
                const bool centred = event.modifiers & Qt::AltModifier;
                const Rectangle target = resized(box, handle, event.snapped, centred);
                return MapChange{.buildings = {building.fitted(target)}};
              },
              QObject::tr("Resize %1").arg(name), Readout::Size};
}

std::optional<Drag> headingDrag(const MapDocument& document, const ToolEvent& press) {
  const std::optional<Pose2>& start = document.map().start;
  if (!start || document.selection() != QStringList{kStartKey} ||
      !isNear(startHandle(*start, press.metres_per_pixel), press))
    return std::nullopt;
  return Drag{[start = *start](const ToolEvent& event) {
                const Vec2 ahead = event.position - start.position();
                const double heading =
                    roundedHeading(std::atan2(ahead.y(), ahead.x()), turnStep(event.modifiers));
                return MapChange{.start = Pose2{start.x, start.y, heading}};
              },
              QObject::tr("Turn Start"), Readout::Heading};
}

std::optional<Drag> routePointDrag(const MapDocument& document, const ToolEvent& press) {
  if (document.selection() != QStringList{kRouteKey}) return std::nullopt;
  const std::vector<Vec2>& route = document.map().route;
  for (std::size_t i = 0; i < route.size(); ++i) {
    if (!isNear(route[i], press)) continue;
    return Drag{[route, i](const ToolEvent& event) {
                  std::vector<Vec2> bent = route;
                  bent[i] = event.snapped;
                  return MapChange{.route = std::move(bent)};
                },
                QObject::tr("Bend Route")};
  }
  return std::nullopt;
}

}  // namespace

const Building* onlyBuilding(const MapDocument& document) {
  const QStringList keys = document.selection();
  return keys.size() == 1 ? document.map().find(keys.first().toStdString()) : nullptr;
}

Vec2 startHandle(const Pose2& start, double metres_per_pixel) {
  return start.position() + kStartHandlePx * metres_per_pixel * unitVector(start.heading);
}

std::optional<Drag> handleDrag(const MapDocument& document, const ToolEvent& press) {
  if (auto drag = buildingDrag(document, press)) return drag;
  if (auto drag = headingDrag(document, press)) return drag;
  return routePointDrag(document, press);
}

Drag moveDrag(const MapDocument& document, const ToolEvent& press) {
  const QStringList keys = document.selection();
  const QString what = keys.size() == 1 ? displayName(document.map(), keys.first())
                                        : QObject::tr("%1 Objects").arg(keys.size());
  return {[objects = selected(document.map(), keys), from = press.snapped](const ToolEvent& event) {
            return moved(objects, event.snapped - from);
          },
          QObject::tr("Move %1").arg(what), Readout::Position};
}

}  // namespace handmap
