#include "widgets/tools/drawing_tool.h"

#include <QPainter>

#include "core/map/map_limits.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kDragPx = 4.0;
constexpr double kCursorPx = 12.0;  ///< half the size of the keyboard's cursor

double degreesOf(const Vec2& offset) { return toDegrees(std::atan2(offset.y(), offset.x())); }

}  // namespace

void DrawingTool::activate() {
  pointer_known_ = by_keys_ = refused_ = false;
  typed_.setCount(numbers().size());
}

bool DrawingTool::cancel() {
  const bool was_busy = isBusy() || pressed_;
  placed_.clear();
  pressed_.reset();
  refused_ = false;
  forgetTyping();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void DrawingTool::interrupt() {
  if (pressed_ && began_by_press_ && !placed().empty()) removeLast();
  pressed_.reset();
  forgetTyping();
  Q_EMIT changed();
}

void DrawingTool::forgetTyping() {
  typed_.clear();
  typed_.setCount(numbers().size());
}

void DrawingTool::take(const ToolEvent& event) {
  pointer_ = event.snapped;
  pointer_known_ = true;
  by_keys_ = false;
  metres_per_pixel_ = event.metres_per_pixel;
  pixel_reach_ = event.reach(1.0);
  modifiers_ = event.modifiers;
}

void DrawingTool::press(const ToolEvent& event) {
  take(event);
  pressed_ = event.position;
  began_by_press_ = placed().empty() && pointCount() != 1;
  refused_ = false;
  if (began_by_press_) {
    append(next());
    forgetTyping();
  }
  Q_EMIT changed();
}

void DrawingTool::move(const ToolEvent& event) {
  take(event);
  if (!isBusy() && !pressed_) return;
  refused_ =
      !closesAt(next()) && (placed().empty() || placed().back() != next()) && !mayPlace(next());
  Q_EMIT changed();
}

void DrawingTool::release(const ToolEvent& event) {
  if (!pressed_) return;
  take(event);
  const bool dragged = (event.position - *pressed_).norm() > kDragPx * event.metres_per_pixel;
  const bool began = began_by_press_;
  pressed_.reset();
  began_by_press_ = false;
  if (!began || dragged) return placeNext();
  if (isCompleteByClick()) return complete();
  Q_EMIT changed();
}

void DrawingTool::doubleClick(const ToolEvent& event) {
  if (pointCount() != 0) return press(event);
  take(event);
  if (canFinish()) finish();
}

void DrawingTool::placeNext() {
  const Vec2 point = next();
  if (closesAt(point) || (pointCount() == 0 && !placed().empty() && placed().back() == point)) {
    if (canFinish()) finish();
    return;
  }
  refused_ = !mayPlace(point);
  if (!refused_) {
    append(point);
    if (placed().size() == pointCount()) return complete();
    pointer_ = point;
    forgetTyping();
  }
  Q_EMIT changed();
}

void DrawingTool::takeBack() {
  if (placed().empty()) return;
  removeLast();
  refused_ = false;
  forgetTyping();
  Q_EMIT changed();
}

bool DrawingTool::wants(QChar character) const {
  if (!isBusy() && !character.isDigit()) return false;
  TypedNumbers tried = typed_;
  tried.setCount(numbers().size());
  return tried.type(character);
}

bool DrawingTool::key(const ToolKey& key) {
  metres_per_pixel_ = key.metres_per_pixel;
  if (!pointer_known_) pointer_ = key.home;
  typed_.setCount(numbers().size());
  switch (key.key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return enter();
    case Qt::Key_Backspace:
      if (typed_.takeBack()) {
        Q_EMIT changed();
        return true;
      }
      if (placed().empty()) return false;
      takeBack();
      return true;
    case Qt::Key_Tab:
      if (!isBusy() || !typed_.next()) return false;
      Q_EMIT changed();
      return true;
    default:
      break;
  }
  if (moveByKey(key)) return true;
  if (key.text.size() != 1 || !typed_.type(key.text.front())) return false;
  pointer_known_ = true;
  Q_EMIT changed();
  return true;
}

bool DrawingTool::moveByKey(const ToolKey& key) {
  Vec2 step = Vec2::Zero();
  switch (key.key) {
    case Qt::Key_Left:
      step.x() = -key.stride_m;
      break;
    case Qt::Key_Right:
      step.x() = key.stride_m;
      break;
    case Qt::Key_Down:
      step.y() = -key.stride_m;
      break;
    case Qt::Key_Up:
      step.y() = key.stride_m;
      break;
    default:
      return false;
  }
  if (key.modifiers & Qt::ShiftModifier) step *= 10.0;
  if (key.modifiers & Qt::ControlModifier) step /= 10.0;
  pointer_ =
      roundedTo(pointer_ + step, Snapper::kTidy).cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
  pointer_known_ = by_keys_ = true;
  modifiers_ = Qt::NoModifier;
  refused_ =
      !placed().empty() && !closesAt(next()) && placed().back() != next() && !mayPlace(next());
  Q_EMIT changed();
  return true;
}

/// With the mouse Enter is "done"; with the arrow keys it is the click.
bool DrawingTool::enter() {
  if (!by_keys_ && typed_.isEmpty() && pointCount() == 0 && !placed().empty()) {
    if (canFinish()) finish();
    return true;
  }
  pointer_known_ = true;
  placeNext();
  return true;
}

std::optional<Vec2> DrawingTool::keyboardCursor() const {
  return by_keys_ ? std::optional(next()) : std::nullopt;
}

std::optional<SnapContext> DrawingTool::snapContext() const {
  SnapContext context;
  const std::vector<Vec2>& points = placed();
  if (!points.empty()) context.from = {points.back()};
  if (points.size() > 1) context.along = points.back() - points[points.size() - 2];
  return context;
}

std::vector<DrawingTool::Number> DrawingTool::numbers() const {
  if (placed().empty()) return {{tr("x"), pointer_.x()}, {tr("y"), pointer_.y()}};
  const Vec2 offset = next() - placed().back();
  return {{tr("Length"), offset.norm()}, {tr("Angle"), degreesOf(offset), true}};
}

Vec2 DrawingTool::constrained(const Vec2& pointer) const {
  const auto first = typed_.value(0);
  const auto second = typed_.value(1);
  Vec2 point;
  if (placed().empty()) {
    point = {first.value_or(pointer.x()), second.value_or(pointer.y())};
  } else if (first || second) {
    const Vec2 offset = pointer - placed().back();
    const double angle = second ? toRadians(*second) : std::atan2(offset.y(), offset.x());
    point = placed().back() + first.value_or(offset.norm()) * unitVector(angle);
  } else {
    return pointer;
  }
  return roundedTo(point, 0.001).cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
}

std::vector<Vec2> DrawingTool::withNext() const {
  std::vector<Vec2> points = placed();
  points.push_back(next());
  return points;
}

void DrawingTool::paint(ToolPaint& canvas) const {
  const QPointF at = canvas.toDevice(next());
  if (by_keys_) {
    canvas.painter.setPen(QPen(canvas.colours[isRefused() ? Role::Problem : Role::Selection], 2.0));
    canvas.painter.drawLine(at - QPointF(kCursorPx, 0.0), at + QPointF(kCursorPx, 0.0));
    canvas.painter.drawLine(at - QPointF(0.0, kCursorPx), at + QPointF(0.0, kCursorPx));
  }
  if (!isBusy() && !by_keys_) return;
  QStringList parts;
  const std::vector<Number> all = numbers();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Number& number = all[i];
    const bool caret = !typed_.isEmpty() && i == typed_.current();
    QString value = typed_.text(i);
    if (value.isEmpty() && !caret) value = QString::number(number.value, 'f', 1);
    if (caret) value += u'|';
    parts << QStringLiteral("%1 %2%3").arg(number.name, value,
                                           number.is_angle ? QStringLiteral("°") : tr(" m"));
  }
  if (!parts.isEmpty()) paintNote(canvas, at + QPointF(0.0, 26.0), parts.join(u"   "));
}

}  // namespace handmap
