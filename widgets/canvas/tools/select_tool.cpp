#include "widgets/canvas/tools/select_tool.h"

#include <QPainter>
#include <utility>

#include "widgets/canvas/hit_test.h"
#include "widgets/canvas/tools/building_handles.h"
#include "widgets/canvas/tools/tool_painting.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr double kHitPx = 5.0;
constexpr double kDragPx = 4.0;

bool extends(Qt::KeyboardModifiers modifiers) {
  return modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
}

}  // namespace

QString SelectTool::hint() const {
  if (rubber_end_) return tr("Release to select what the frame touches · Shift adds to it");
  if (drag_ && drag_->readout == Readout::Size)
    return tr("Release to resize · Alt: about the centre · Esc: cancel");
  if (drag_ && drag_->readout == Readout::Heading)
    return tr("Release to turn · Shift: steps of 15° · Esc: cancel");
  if (drag_) return tr("Release to place it · Esc: cancel");
  if (document().selection().isEmpty())
    return tr("Click or drag a frame to select · Shift adds · Space or middle button pans");
  if (document().selection() == QStringList{kRouteKey})
    return tr("Drag a point to bend the route, a line to move it · Del removes");
  if (onlyBuilding(document()) || document().selection() == QStringList{kStartKey})
    return tr("Drag to move · handles resize and turn · arrow keys nudge · Del removes");
  return tr("Drag to move · arrow keys nudge · Del removes · Shift adds to the selection");
}

bool SelectTool::cancel() {
  const bool was_busy = pressed_.has_value();
  drag_.reset();
  preview_.reset();
  pressed_.reset();
  rubber_end_.reset();
  clicked_.clear();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void SelectTool::press(const ToolEvent& event) {
  cancel();
  pressed_ = event;
  drag_ = handleDrag(document(), event);
  if (drag_) return;
  const QString key = objectAt(document().map(), event.position, kHitPx * event.metres_per_pixel);
  if (key.isEmpty()) return;
  selectPressed(key, event.modifiers);
  if (document().selection().contains(key)) drag_ = moveDrag(document(), event);
}

void SelectTool::selectPressed(const QString& key, Qt::KeyboardModifiers modifiers) {
  QStringList keys = document().selection();
  const bool was_selected = keys.contains(key);
  if (!extends(modifiers)) {
    if (was_selected)
      clicked_ = key;
    else
      keys = {key};
  } else if (was_selected) {
    keys.removeAll(key);
  } else {
    keys << key;
  }
  document().setSelection(keys);
}

void SelectTool::move(const ToolEvent& event) {
  if (!pressed_) return updateCursor(event);
  const double way = (event.position - pressed_->position).norm();
  if (!preview_ && !rubber_end_ && way < kDragPx * event.metres_per_pixel) return;
  if (drag_)
    preview_ = drag_->change(event);
  else
    rubber_end_ = event.position;
  Q_EMIT changed();
}

void SelectTool::release(const ToolEvent& event) {
  if (!pressed_) return;
  if (preview_) {
    const MapChange change = std::move(*preview_);
    preview_.reset();
    document().apply(change, drag_->text);
  } else if (rubber_end_) {
    const Bounds box{pressed_->position.cwiseMin(event.position),
                     pressed_->position.cwiseMax(event.position)};
    QStringList keys = extends(event.modifiers) ? document().selection() : QStringList();
    document().setSelection(keys + objectsIn(document().map(), box));
  } else if (!clicked_.isEmpty()) {
    document().setSelection({clicked_});
  } else if (!drag_ && !extends(event.modifiers)) {
    document().setSelection({});
  }
  cancel();
}

bool SelectTool::key(const ToolKey& key) {
  const QStringList keys = document().selection();
  if (keys.isEmpty() || pressed_) return false;
  Vec2 step = Vec2::Zero();
  switch (key.key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      document().removeSelected();
      return true;
    case Qt::Key_Left:
      step.x() = -key.step_m;
      break;
    case Qt::Key_Right:
      step.x() = key.step_m;
      break;
    case Qt::Key_Down:
      step.y() = -key.step_m;
      break;
    case Qt::Key_Up:
      step.y() = key.step_m;
      break;
    default:
      return false;
  }
  if (key.modifiers & Qt::ShiftModifier) step *= 10.0;
  document().apply(moved(selected(document().map(), keys), step), tr("Nudge"), true);
  return true;
}

void SelectTool::updateCursor(const ToolEvent& event) {
  Qt::CursorShape shape = Qt::ArrowCursor;
  if (const Building* building = onlyBuilding(document())) {
    const Rectangle box = building->box();
    if (const auto handle = handleAt(box, event.position, event.metres_per_pixel))
      shape = cursorOf(box, *handle);
    else if (distanceTo(building->footprint(), event.position) <= kHitPx * event.metres_per_pixel)
      shape = Qt::SizeAllCursor;
  }
  if (std::exchange(cursor_, shape) != shape) Q_EMIT changed();
}

void SelectTool::paint(ToolPaint& canvas) const {
  QPainter& painter = canvas.painter;
  if (rubber_end_) {
    painter.setPen(canvas.colours.pen(Role::Preview));
    painter.setBrush(canvas.colours.brush(Role::Preview));
    painter.drawRect(
        QRectF(canvas.toDevice(pressed_->position), canvas.toDevice(*rubber_end_)).normalized());
    return;
  }
  if (preview_) return paintReadout(canvas);
  if (const Building* building = onlyBuilding(document())) paintHandles(canvas, building->box());
  const Map& map = document().map();
  if (document().selection() == QStringList{kStartKey})
    paintHandle(canvas, startHandle(*map.start, canvas.metresPerPixel()), true);
  if (document().selection() == QStringList{kRouteKey})
    for (const Vec2& point : map.route) paintHandle(canvas, point);
}

void SelectTool::paintReadout(ToolPaint& canvas) const {
  if (document().selection().size() != 1) return;
  const auto& start = preview_->start;
  if (start) {
    const QString text = drag_->readout == Readout::Heading ? degreesText(start->heading)
                                                            : positionText(start->position());
    paintNote(canvas, canvas.toDevice(start->position()) + QPointF(0.0, 26.0), text);
  }
  if (preview_->buildings.empty()) return;
  const Rectangle box = preview_->buildings.front().box();
  const Vec2 handle = handlePosition(box, {}, canvas.metresPerPixel());
  if (drag_->readout == Readout::Size) paintSizes(canvas, box);
  if (drag_->readout == Readout::Heading)
    paintNote(canvas, canvas.toDevice(handle), degreesText(box.heading));
  if (drag_->readout == Readout::Position)
    paintNote(canvas, canvas.toDevice(handle), positionText(box.centre));
}

}  // namespace handmap
