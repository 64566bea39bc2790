// How the canvas takes mouse, wheel, gestures and keys, and what of it the tools are told.
#include <QGestureEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <algorithm>
#include <cmath>

#include "core/map/map_limits.h"
#include "widgets/canvas/map_canvas.h"

namespace handmap {

namespace {

constexpr double kWheelNotch = 120.0;
constexpr double kZoomPerNotch = 1.25;
constexpr double kUnsnappedStep = 0.01;  // metres
constexpr double kNudgeStep = 0.1;       // metres

Vec2 rounded(const Vec2& point, double step) {
  // Through the number of steps in one, so that 0.1-steps give 0.3 and not 0.30000000000000004.
  const double steps = std::round(1.0 / step);
  return (point * steps).array().round() / steps;
}

}  // namespace

ToolEvent MapCanvas::toolEvent(const QMouseEvent& event) const {
  const QPointF metres = viewportTransform().inverted().map(event.position());
  ToolEvent result;
  result.position = Vec2(metres.x(), metres.y()).cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
  result.snapped = rounded(result.position, snap_step_ > 0.0 ? snap_step_ : kUnsnappedStep);
  result.metres_per_pixel = 1.0 / pixelsPerMetre();
  result.button = event.button();
  result.modifiers = event.modifiers();
  result.pressure = event.points().isEmpty() ? 1.0 : event.points().first().pressure();
  result.pointer = event.pointerType();
  return result;
}

void MapCanvas::updateCursor() {
  const Qt::CursorShape shape = pan_from_     ? Qt::ClosedHandCursor
                                : space_held_ ? Qt::OpenHandCursor
                                              : tool_->cursor();
  if (viewport()->cursor().shape() != shape) viewport()->setCursor(shape);
}

void MapCanvas::mousePressEvent(QMouseEvent* event) {
  fitted_ = false;  // whoever works on it keeps it where it is
  if (event->button() == Qt::MiddleButton || (space_held_ && event->button() == Qt::LeftButton)) {
    pan_from_ = event->position();
    updateCursor();
  } else if (event->button() == Qt::LeftButton) {
    tool_->press(toolEvent(*event));
  } else if (event->button() == Qt::RightButton) {
    tool_->cancel();
  }
}

void MapCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (pan_from_) {
    Q_EMIT movedByHand();
    panBy(event->position() - *std::exchange(pan_from_, event->position()));
  } else {
    tool_->move(toolEvent(*event));
  }
  Q_EMIT cursorMoved(viewportTransform().inverted().map(event->position()));
}

void MapCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (pan_from_ && event->button() != Qt::RightButton) {
    pan_from_.reset();
    updateCursor();
  } else if (event->button() == Qt::LeftButton) {
    tool_->release(toolEvent(*event));
  }
}

void MapCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && !space_held_)
    tool_->doubleClick(toolEvent(*event));
  else
    mousePressEvent(event);
}

void MapCanvas::wheelEvent(QWheelEvent* event) {
  event->accept();
  const bool two_fingers = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  const bool pans = (event->modifiers() & Qt::ShiftModifier) ||
                    (two_fingers && !(event->modifiers() & Qt::ControlModifier));
  if (pans) {
    Q_EMIT movedByHand();
    return panBy(event->modifiers() & Qt::ShiftModifier ? event->angleDelta()
                                                        : event->pixelDelta());
  }
  zoomAt(event->position(), std::pow(kZoomPerNotch, event->angleDelta().y() / kWheelNotch));
}

bool MapCanvas::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture) {
      zoomAt(gesture.position(), 1.0 + gesture.value());
      return true;
    }
  } else if (event->type() == QEvent::Gesture) {
    auto& gestures = static_cast<QGestureEvent&>(*event);
    if (const auto* pinch = static_cast<QPinchGesture*>(gestures.gesture(Qt::PinchGesture))) {
      tool_->cancel();
      Q_EMIT movedByHand();
      const QPointF centre = viewport()->mapFromGlobal(pinch->centerPoint());
      zoomAt(centre, pinch->scaleFactor());
      panBy(pinch->centerPoint() - pinch->lastCenterPoint());
      return true;
    }
  }
  return QGraphicsView::viewportEvent(event);
}

void MapCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    space_held_ = true;
    updateCursor();
  } else if (event->key() == Qt::Key_Escape) {
    escape();
  } else if (event->key() != Qt::Key_Space) {
    const double step = snap_step_ > 0.0 ? snap_step_ : kNudgeStep;
    event->setAccepted(tool_->key({event->key(), event->modifiers(), step}));
  }
}

void MapCanvas::escape() {
  if (tool_->cancel()) return;
  if (tool() != ToolId::Select)
    setTool(ToolId::Select);
  else
    document_.setSelection({});
}

void MapCanvas::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Space || event->isAutoRepeat()) return event->ignore();
  space_held_ = false;
  updateCursor();
}

void MapCanvas::focusOutEvent(QFocusEvent* event) {
  space_held_ = false;
  updateCursor();
  QGraphicsView::focusOutEvent(event);
}

void MapCanvas::showEvent(QShowEvent* event) {
  QGraphicsView::showEvent(event);
  if (fitted_) zoomToFit();
}

void MapCanvas::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if (fitted_ && isVisible()) zoomToFit();
}

void MapCanvas::changeEvent(QEvent* event) {
  QGraphicsView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyPalette();
}

}  // namespace handmap
