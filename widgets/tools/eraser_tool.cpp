#include "widgets/tools/eraser_tool.h"

#include <QPainter>

#include "widgets/canvas/hit_test.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kEraserReachPx = 4.0;

bool isLocked(const Map& map, const QString& key) { return unlocked(map, {key}).isEmpty(); }

}  // namespace

QString EraserTool::hint() const {
  if (pressed_) return tr("Release to erase what is crossed out · Esc: cancel");
  return tr("Drag over what shall go, or click it · what is locked stays");
}

bool EraserTool::cancel() {
  const bool was_busy = pressed_;
  pressed_ = false;
  touched_.clear();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void EraserTool::press(const ToolEvent& event) {
  cancel();
  cursor_.reset();
  pressed_ = true;
  last_ = event.position;
  touch(event);
}

void EraserTool::move(const ToolEvent& event) {
  if (pressed_) touch(event);
}

/// All that lies between where the pointer was and where it is.
void EraserTool::touch(const ToolEvent& event) {
  const double reach = event.reach(kEraserReachPx);
  const double dragged = (event.position - last_).norm();
  const int steps = std::clamp(static_cast<int>(std::ceil(dragged / reach)), 1, 500);
  for (int i = 0; i <= steps; ++i) {
    const Vec2 at = last_ + (event.position - last_) * i / steps;
    const QString key = objectAt(document(), at, reach);
    if (!key.isEmpty() && !touched_.contains(key) && !isLocked(document().map(), key))
      touched_ << key;
  }
  last_ = event.position;
  Q_EMIT changed();
}

void EraserTool::release(const ToolEvent& event) {
  if (!pressed_) return;
  touch(event);
  const QStringList touched = touched_;
  cancel();
  if (!touched.isEmpty()) document().remove(touched);
}

bool EraserTool::key(const ToolKey& key) {
  Vec2 step = Vec2::Zero();
  switch (key.key) {
    case Qt::Key_Left:
      step.x() = -1.0;
      break;
    case Qt::Key_Right:
      step.x() = 1.0;
      break;
    case Qt::Key_Down:
      step.y() = -1.0;
      break;
    case Qt::Key_Up:
      step.y() = 1.0;
      break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (cursor_) {
        const QString there = objectAt(document(), *cursor_, kEraserReachPx * key.metres_per_pixel);
        if (!there.isEmpty() && !isLocked(document().map(), there)) document().remove({there});
      }
      return cursor_.has_value();
    default:
      return false;
  }
  cursor_ = cursor_.value_or(key.home) +
            step * key.stride_m * (key.modifiers & Qt::ShiftModifier ? 10.0 : 1.0);
  Q_EMIT changed();
  return true;
}

void EraserTool::paint(ToolPaint& canvas) const {
  const Map& map = document().map();
  for (const QString& key : touched_) {
    const auto bounds = boundsOf(map, key);
    if (!bounds) continue;
    canvas.painter.setPen(canvas.colours.pen(Role::Problem));
    canvas.painter.setBrush(canvas.colours.brush(Role::Problem));
    const QRectF box =
        QRectF(canvas.toDevice(bounds->low), canvas.toDevice(bounds->high)).normalized();
    canvas.painter.drawRect(box.adjusted(-4.0, -4.0, 4.0, 4.0));
    canvas.painter.drawLine(box.topLeft(), box.bottomRight());
    canvas.painter.drawLine(box.topRight(), box.bottomLeft());
  }
  if (!cursor_) return;
  const QPointF at = canvas.toDevice(*cursor_);
  canvas.painter.setPen(QPen(canvas.colours[Role::Problem], 2.0));
  canvas.painter.setBrush(Qt::NoBrush);
  canvas.painter.drawEllipse(at, 8.0, 8.0);
}

}  // namespace handmap
