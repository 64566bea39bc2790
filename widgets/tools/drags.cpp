#include "widgets/tools/drags.h"

#include "widgets/canvas/building_handles.h"
#include "widgets/tools/corner_handles.h"

namespace handmap {

namespace {

constexpr double kStartHandlePx = 38.0;
constexpr double kFramePx = 14.0;  ///< between a polygon and the frame with its handles
constexpr std::size_t kMostMovedCorners = 8;

/// Free turns are rounded to tidy numbers, held ones to steps one can see.
double turnStep(Qt::KeyboardModifiers modifiers) {
  return modifiers & (Qt::ShiftModifier | Qt::ControlModifier) ? 15.0 : 0.5;
}

std::optional<Drag> buildingDrag(const MapDocument& document, const ToolEvent& press) {
  const Building* building = onlyBuilding(document);
  if (!building || building->flags.locked) return std::nullopt;
  const Rectangle box = building->box();
  const Rectangle frame = handleFrame(*building, press.metres_per_pixel);
  const auto handle = handleAt(frame, press.position, press.reach(1.0));
  if (!handle) return std::nullopt;
  const QString name = displayName(document.map(), document.selection().constFirst());
  if (handle->turns())
    return Drag{[building = *building, box](const ToolEvent& event) {
                  const Rectangle target = turned(box, event.position, turnStep(event.modifiers));
                  return MapChange{.buildings = {building.fitted(target)}};
                },
                QObject::tr("Turn %1").arg(name), Readout::Heading};
  const Vec2 beyond = handlePosition(frame, *handle, press.metres_per_pixel) -
                      handlePosition(box, *handle, press.metres_per_pixel);
  return Drag{[building = *building, box, handle = *handle, beyond](const ToolEvent& event) {
                const bool centred = event.modifiers & Qt::ControlModifier;
                const Rectangle target = resized(box, handle, event.snapped - beyond, centred);
                return MapChange{.buildings = {building.fitted(target)}};
              },
              QObject::tr("Resize %1").arg(name), Readout::Size,
              SnapContext{.ignored = document.selection()}};
}

std::optional<Drag> cornerDrag(const MapDocument& document, const ToolEvent& press) {
  const auto line = selectedCorners(document);
  const auto handle = line ? cornerHandleAt(*line, press) : std::nullopt;
  if (!handle) return std::nullopt;
  const std::size_t count = line->corners.size();
  const std::size_t corner = handle->between ? handle->corner + 1 : handle->corner;
  SnapContext snap{.ignored = document.selection()};
  if (handle->between) {
    snap.from = {line->corners[handle->corner], line->corners[(handle->corner + 1) % count]};
  } else {
    if (line->closed || corner > 0)
      snap.from.push_back(line->corners[(corner + count - 1) % count]);
    if (line->closed || corner + 1 < count)
      snap.from.push_back(line->corners[(corner + 1) % count]);
  }
  return Drag{[&document, handle = *handle](const ToolEvent& event) {
                return withCornerMoved(document, handle, event.snapped);
              },
              document.selection() == QStringList{kRouteKey} ? QObject::tr("Bend Route")
              : handle->between                              ? QObject::tr("Add Corner")
                                                             : QObject::tr("Move Corner"),
              Readout::Position, std::move(snap), corner};
}

std::optional<Drag> headingDrag(const MapDocument& document, const ToolEvent& press) {
  const std::optional<Pose2>& start = document.map().start;
  if (!start || document.selection() != QStringList{kStartKey} ||
      !press.isNear(startHandle(*start, press.metres_per_pixel), kHandleReachPx))
    return std::nullopt;
  return Drag{[start = *start](const ToolEvent& event) {
                const Vec2 ahead = event.position - start.position();
                const double heading =
                    roundedHeading(std::atan2(ahead.y(), ahead.x()), turnStep(event.modifiers));
                return MapChange{.start = Pose2{start.x, start.y, heading}};
              },
              QObject::tr("Turn Start"), Readout::Heading};
}

}  // namespace

const Building* onlyBuilding(const MapDocument& document) {
  const QStringList keys = document.selection();
  return keys.size() == 1 ? document.map().find(keys.first().toStdString()) : nullptr;
}

Rectangle handleFrame(const Building& building, double metres_per_pixel) {
  Rectangle frame = building.box();
  if (std::holds_alternative<Rectangle>(building.shape)) return frame;
  frame.width += 2.0 * kFramePx * metres_per_pixel;
  frame.depth += 2.0 * kFramePx * metres_per_pixel;
  return frame;
}

Vec2 startHandle(const Pose2& start, double metres_per_pixel) {
  return start.position() + kStartHandlePx * metres_per_pixel * unitVector(start.heading);
}

std::optional<Drag> handleDrag(const MapDocument& document, const ToolEvent& press) {
  if (auto drag = cornerDrag(document, press)) return drag;
  if (auto drag = buildingDrag(document, press)) return drag;
  return headingDrag(document, press);
}

std::optional<Drag> moveDrag(const MapDocument& document, const ToolEvent& press) {
  const QStringList keys = document.selection();
  MapChange objects = movable(document.map(), keys);
  if (objects.isEmpty()) return std::nullopt;
  SnapContext snap{.ignored = keys, .grip = press.snapped};
  for (const Building& building : objects.buildings) {
    const Polygon corners = building.footprint();
    if (snap.moved_corners.size() + corners.size() > kMostMovedCorners) break;
    snap.moved_corners.insert(snap.moved_corners.end(), corners.begin(), corners.end());
  }
  const QString what = keys.size() == 1 ? displayName(document.map(), keys.first())
                                        : QObject::tr("%1 Objects").arg(keys.size());
  return Drag{[objects = std::move(objects), from = press.snapped](const ToolEvent& event) {
                return moved(objects, event.snapped - from);
              },
              QObject::tr("Move %1").arg(what), Readout::Position, std::move(snap)};
}

}  // namespace handmap
