// How the canvas takes mouse, wheel and keys, and what of it the tools are told.
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/map/map_limits.h"
#include "widgets/canvas/hit_test.h"
#include "widgets/canvas/map_canvas.h"
#include "widgets/canvas/name_editor.h"
#include "widgets/canvas/rulers.h"

namespace handmap {

namespace {

constexpr double kWheelNotch = 120.0;
constexpr double kZoomPerNotch = 1.25;
constexpr double kNudgeStep = 0.1;  // metres
constexpr double kSnapPx = 9.0;
constexpr double kStridePx = 6.0;  // at least so far goes the keyboard's cursor with a key
constexpr double kHitPx = 5.0;

}  // namespace

Vec2 MapCanvas::toMetres(QPointF viewport_position) const {
  const QPointF metres = viewportTransform().inverted().map(viewport_position);
  return Vec2(metres.x(), metres.y()).cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
}

ToolEvent MapCanvas::toolEvent(QPointF viewport_position, Qt::KeyboardModifiers modifiers) {
  ToolEvent result;
  result.position = toMetres(viewport_position);
  result.metres_per_pixel = 1.0 / pixelsPerMetre();
  result.modifiers = modifiers;
  snap_ = snapping_.snap(result.position, kSnapPx * result.metres_per_pixel, tool_->snapContext(),
                         modifiers & Qt::AltModifier);
  result.snapped = snap_.point.cwiseMax(-kMaxCoordinate).cwiseMin(kMaxCoordinate);
  return result;
}

ToolEvent MapCanvas::toolEvent(const QMouseEvent& event) {
  ToolEvent result = toolEvent(event.position(), event.modifiers());
  result.button = event.button();
  result.pressure = event.points().isEmpty() ? 1.0 : event.points().first().pressure();
  result.pointer = event.pointerType();
  return result;
}

/// Whatever is pressed ends what could still be typed.
void MapCanvas::press(const ToolEvent& event) {
  fitted_ = false;  // whoever works on it keeps it where it is
  menu_at_.reset();
  name_->commit();
  if (selectCorrected(event)) return;
  tool_->press(event);
}

/// Where nothing drawn lies, a corrected building is the thing that is clicked.
bool MapCanvas::selectCorrected(const ToolEvent& event) {
  const bool free = tool() == ToolId::Select && tool_->cursor() == Qt::ArrowCursor &&
                    objectAt(document_, event.position, kHitPx * event.metres_per_pixel).isEmpty();
  const QString id = free ? corrected_at_(event.position) : QString();
  if (id.isEmpty() || !document_.map().find(id.toStdString())) return false;
  const bool adds = event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  document_.setSelection(adds ? document_.selection() + QStringList{id} : QStringList{id});
  return true;
}

void MapCanvas::updateCursor() {
  const Qt::CursorShape shape = pan_from_     ? Qt::ClosedHandCursor
                                : space_held_ ? Qt::OpenHandCursor
                                              : tool_->cursor();
  if (viewport()->cursor().shape() != shape) viewport()->setCursor(shape);
}

void MapCanvas::mousePressEvent(QMouseEvent* event) {
  cancelled_by_press_ = false;
  if (event->button() == Qt::MiddleButton || (space_held_ && event->button() == Qt::LeftButton)) {
    pan_from_ = event->position();
    updateCursor();
  } else if (event->button() == Qt::LeftButton) {
    press(toolEvent(*event));
  } else if (event->button() == Qt::RightButton) {
    cancelled_by_press_ = tool_->cancel();
  }
}

void MapCanvas::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
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

void MapCanvas::leaveEvent(QEvent* event) {
  pointer_.reset();
  QGraphicsView::leaveEvent(event);
}

void MapCanvas::contextMenuEvent(QContextMenuEvent* event) {
  event->accept();
  if (std::exchange(cancelled_by_press_, false)) return;
  if (event->reason() == QContextMenuEvent::Keyboard) {
    const QString key = document_.selection().value(0);
    const auto bounds = key.isEmpty() ? std::nullopt : boundsOf(document_.map(), key);
    const Vec2 middle = bounds ? Vec2((bounds->low + bounds->high) / 2.0) : pastePosition();
    menu_at_.reset();
    Q_EMIT contextMenuRequested(viewport()->mapToGlobal(
        viewportTransform().map(QPointF(middle.x(), middle.y())).toPoint()));
    return;
  }
  showMenuAt(event->pos());
}

void MapCanvas::showMenuAt(QPointF viewport_position) {
  tool_->interrupt();
  const ToolEvent at = toolEvent(viewport_position, Qt::NoModifier);
  Tool* select = toolOf(ToolId::Select);
  if (select == nullptr || !select->chooseAt(at)) {
    QString key = objectAt(document_, at.position, kHitPx * at.metres_per_pixel);
    if (key.isEmpty()) key = corrected_at_(at.position);
    if (!document_.selection().contains(key))
      document_.setSelection(key.isEmpty() ? QStringList() : QStringList{key});
  }
  menu_at_ = viewport_position;
  Q_EMIT contextMenuRequested(viewport()->mapToGlobal(viewport_position.toPoint()));
}

// --- Keys

bool MapCanvas::event(QEvent* event) {
  // What is a letter of a name or a digit of a number is no shortcut.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<QKeyEvent&>(*event);
    const bool plain = !(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier));
    const QChar character = key.text().isEmpty() ? QChar() : key.text().front();
    if (plain && (name_->wants(character) || tool_->wants(character))) {
      event->accept();
      return true;
    }
  }
  return QGraphicsView::event(event);
}

/// What lies on it and goes with the focus asks too: that is no key.
bool MapCanvas::focusNextPrevChild(bool next) {
  const QKeyEvent key(QEvent::KeyPress, next ? Qt::Key_Tab : Qt::Key_Backtab, Qt::NoModifier);
  return (hasFocus() && giveKey(key)) || QGraphicsView::focusNextPrevChild(next);
}

bool MapCanvas::giveKey(const QKeyEvent& event) {
  ToolKey key{event.key(), event.modifiers()};
  key.step_m = snapModes().grid ? CanvasSnapping::kGridStep : kNudgeStep;
  key.text = event.text();
  key.metres_per_pixel = 1.0 / pixelsPerMetre();
  key.stride_m = std::max(key.step_m, roundedStep(kStridePx * key.metres_per_pixel));
  const Vec2 home = toMetres(pointer_.value_or(viewport()->rect().toRectF().center()));
  key.home = roundedTo(home, pointer_ ? Snapper::kTidy : key.stride_m);
  snap_ = {};
  return tool_->key(key);
}

void MapCanvas::keyPressEvent(QKeyEvent* event) {
  const bool plain = !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    space_held_ = true;
    updateCursor();
  } else if (event->key() == Qt::Key_Escape) {
    name_->disarm();
    escape();
  } else if (plain && event->text().size() == 1 && name_->wants(event->text().front())) {
    name_->beginArmed(event->text());
    layOut();
  } else if (name_->isArmed() &&
             (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
    name_->beginArmed();
  } else if (event->key() != Qt::Key_Space) {
    event->setAccepted(giveKey(*event));
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
  layOut();
  if (fitted_ && isVisible()) zoomToFit();
}

void MapCanvas::changeEvent(QEvent* event) {
  QGraphicsView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) applyPalette();
}

}  // namespace handmap
