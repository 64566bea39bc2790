// How the canvas takes fingers and pens: one finger is the tool, two move and zoom, a long press is
// the context menu, the other end of a pen erases.
#include <QNativeGestureEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <cmath>
#include <utility>

#include "widgets/canvas/map_canvas.h"

namespace handmap {

namespace {

constexpr int kLongPressMs = 600;
constexpr int kDoubleTapMs = 400;
constexpr double kTremblePx = 12.0;  // a finger that moves less rests
constexpr double kTapPx = 30.0;      // two taps this near are one double tap

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

}  // namespace

bool MapCanvas::viewportEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::NativeGesture: {
      const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
      if (gesture.gestureType() != Qt::ZoomNativeGesture) break;
      zoomAt(gesture.position(), 1.0 + gesture.value());
      return true;
    }
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      if (takeTouch(static_cast<QTouchEvent&>(*event))) return true;
      break;
    case QEvent::TabletPress:
    case QEvent::TabletMove:
    case QEvent::TabletRelease:
      if (takeEraser(static_cast<QTabletEvent&>(*event))) return true;
      break;
    default:
      break;
  }
  return QGraphicsView::viewportEvent(event);
}

bool MapCanvas::takeTouch(QTouchEvent& event) {
  if (event.device() && event.device()->type() != QInputDevice::DeviceType::TouchScreen)
    return false;
  event.accept();
  if (event.type() == QEvent::TouchCancel || event.points().isEmpty()) {
    if (fingers_ == Fingers::One) tool_->interrupt();
    fingers_ = Fingers::None;
    long_press_.stop();
    return true;
  }
  const QPointF at = event.points().first().position();
  ToolEvent tool_event = toolEvent(at, event.modifiers());
  tool_event.pointer = QPointingDevice::PointerType::Finger;
  if (event.points().size() > 1) {
    if (fingers_ == Fingers::One) tool_->interrupt();
    if (fingers_ != Fingers::Two) two_at_.reset();
    long_press_.stop();
    fingers_ = Fingers::Two;
    moveByTwo(event);
  } else if (event.type() == QEvent::TouchBegin) {
    two_at_.reset();
    beginTouch(tool_event, at);
  } else if (event.type() == QEvent::TouchUpdate && fingers_ == Fingers::One) {
    if (distance(at, touched_at_) > kTremblePx) long_press_.stop();
    tool_->move(tool_event);
    Q_EMIT cursorMoved(viewportTransform().inverted().map(at));
  }
  if (event.type() == QEvent::TouchEnd) endTouch(tool_event, at);
  return true;
}

void MapCanvas::beginTouch(const ToolEvent& event, QPointF at) {
  setFocus(Qt::MouseFocusReason);
  fingers_ = Fingers::One;
  const bool again = since_tap_.isValid() && since_tap_.elapsed() < kDoubleTapMs &&
                     distance(at, tapped_at_) < kTapPx;
  touched_at_ = at;
  if (again) {
    since_tap_.invalidate();
    fingers_ = Fingers::Done;
    tool_->doubleClick(event);
    return;
  }
  long_press_.start(kLongPressMs, this);
  press(event);
}

void MapCanvas::endTouch(const ToolEvent& event, QPointF at) {
  long_press_.stop();
  const bool was_one = fingers_ == Fingers::One;
  fingers_ = Fingers::None;
  if (!was_one) return;
  tool_->release(event);
  if (distance(at, touched_at_) > kTremblePx) return;
  tapped_at_ = at;
  since_tap_.start();
}

/// What was between the fingers stays between them.
void MapCanvas::moveByTwo(const QTouchEvent& event) {
  const QLineF now(event.points()[0].position(), event.points()[1].position());
  const auto before = std::exchange(two_at_, now);
  if (!before) return;
  Q_EMIT movedByHand();
  panBy(now.center() - before->center());
  if (before->length() > 1.0 && now.length() > 1.0)
    zoomAt(now.center(), now.length() / before->length());
}

void MapCanvas::timerEvent(QTimerEvent* event) {
  if (event->timerId() != long_press_.timerId()) return QGraphicsView::timerEvent(event);
  long_press_.stop();
  // Who draws may rest a finger.
  if (fingers_ != Fingers::One || tool_->isBusy()) return;
  fingers_ = Fingers::Done;
  showMenuAt(touched_at_);
}

bool MapCanvas::takeEraser(QTabletEvent& event) {
  const bool is_eraser = event.pointerType() == QPointingDevice::PointerType::Eraser;
  Tool* eraser = toolOf(ToolId::Eraser);
  if (eraser == nullptr || (!is_eraser && !before_eraser_)) return false;
  event.accept();
  if (event.type() == QEvent::TabletPress) {
    tool_->interrupt();
    before_eraser_ = tool_;
    tool_ = eraser;
  }
  if (!before_eraser_) return true;
  ToolEvent tool_event = toolEvent(event.position(), event.modifiers());
  tool_event.pointer = QPointingDevice::PointerType::Eraser;
  tool_event.pressure = event.pressure();
  if (event.type() == QEvent::TabletPress) {
    press(tool_event);
  } else if (event.type() == QEvent::TabletMove) {
    tool_->move(tool_event);
  } else {
    tool_->release(tool_event);
    tool_ = before_eraser_;
    before_eraser_ = nullptr;
    onToolChanged();
  }
  return true;
}

}  // namespace handmap
