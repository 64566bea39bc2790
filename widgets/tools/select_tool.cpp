#include "widgets/tools/select_tool.h"

#include <QPainter>
#include <utility>

#include "widgets/canvas/building_handles.h"
#include "widgets/canvas/hit_test.h"
#include "widgets/style/colours.h"
#include "widgets/tools/corner_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kHitPx = 5.0;
constexpr double kDragPx = 4.0;

bool extends(Qt::KeyboardModifiers modifiers) {
  return modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
}

std::optional<Vec2> directionOf(int key) {
  switch (key) {
    case Qt::Key_Left:
      return Vec2(-1.0, 0.0);
    case Qt::Key_Right:
      return Vec2(1.0, 0.0);
    case Qt::Key_Down:
      return Vec2(0.0, -1.0);
    case Qt::Key_Up:
      return Vec2(0.0, 1.0);
    default:
      return std::nullopt;
  }
}

}  // namespace

QString SelectTool::hint() const {
  if (refused_) return tr("The outline must not cross itself");
  if (rubber_end_) return tr("Release to select what the frame touches · Shift adds to it");
  if (drag_ && drag_->readout == Readout::Size)
    return tr("Release to resize · Ctrl: about the centre · Alt: no snapping · Esc: cancel");
  if (drag_ && drag_->readout == Readout::Heading)
    return tr("Release to turn · Shift: steps of 15° · Esc: cancel");
  if (drag_) return tr("Release to place it · Alt: no snapping · Esc: cancel");
  if (chosenCorner())
    return tr("Arrow keys move the corner · Ins adds one · Del removes it · Tab: the next");
  if (document().selection().isEmpty())
    return tr("Click or drag a frame to select · Shift adds · Tab: the next · Space pans");
  if (document().selection() == QStringList{kRouteKey})
    return tr("Drag a point to bend the route, a line to move it · Del removes");
  const Building* building = onlyBuilding(document());
  if (building && building->flags.locked) return tr("It is locked · Ctrl+L unlocks it");
  if (building && std::holds_alternative<Polygon>(building->shape))
    return tr("Drag corners, or a dot to add one · Enter: corners by keys · arrow keys nudge");
  if (building || document().selection() == QStringList{kStartKey})
    return tr("Drag to move · handles resize and turn · arrow keys nudge · Del removes");
  return tr("Drag to move · arrow keys nudge · Del removes · Shift adds to the selection");
}

bool SelectTool::cancel() {
  if (dropPress()) return true;
  if (!chosenCorner()) return false;
  chooseCorner(std::nullopt);
  return true;
}

bool SelectTool::dropPress() {
  const bool was_pressed = pressed_.has_value();
  drag_.reset();
  preview_.reset();
  pressed_.reset();
  rubber_end_.reset();
  clicked_.clear();
  refused_ = false;
  if (was_pressed) Q_EMIT changed();
  return was_pressed;
}

void SelectTool::press(const ToolEvent& event) {
  corner_.reset();
  dropPress();
  pressed_ = event;
  drag_ = handleDrag(document(), event);
  if (drag_) return chooseCorner(drag_->corner);
  const QString key = objectAt(document(), event.position, event.reach(kHitPx));
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
  const double dragged = (event.position - pressed_->position).norm();
  if (!preview_ && !rubber_end_ && dragged < event.reach(kDragPx)) return;
  if (drag_) {
    std::optional<MapChange> change = drag_->change(event);
    refused_ = !change;
    if (change) preview_ = std::move(change);
  } else {
    rubber_end_ = event.position;
  }
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
    document().setSelection(keys + objectsIn(document(), box));
  } else if (!clicked_.isEmpty()) {
    document().setSelection({clicked_});
  } else if (!drag_ && !extends(event.modifiers) &&
             objectAt(document(), event.position, event.reach(kHitPx)).isEmpty()) {
    document().setSelection({});
  }
  dropPress();
}

void SelectTool::doubleClick(const ToolEvent& event) {
  if (isOnEdge(event) && selectedCorners(document())) {
    addCornerAt(event.position, event.reach(kHitPx));
    return;
  }
  const QString key = objectAt(document(), event.position, event.reach(kHitPx));
  if (!key.isEmpty() && key != kStartKey && key != kRouteKey)
    Q_EMIT renameRequested(key);
  else
    press(event);
}

std::optional<SnapContext> SelectTool::snapContext() const {
  if (!drag_ || !pressed_ || drag_->readout == Readout::Heading) return std::nullopt;
  return drag_->snap;
}

// --- Corners

std::optional<std::size_t> SelectTool::chosenCorner() const {
  if (!corner_ || document().selection() != QStringList{corner_of_}) return std::nullopt;
  const auto line = selectedCorners(document());
  return line && *corner_ < line->corners.size() ? corner_ : std::nullopt;
}

void SelectTool::chooseCorner(std::optional<std::size_t> corner) {
  corner_ = corner;
  corner_of_ = document().selection().value(0);
  Q_EMIT changed();
}

bool SelectTool::chooseAt(const ToolEvent& event) {
  const auto line = selectedCorners(document());
  const auto handle = line ? cornerHandleAt(*line, event) : std::nullopt;
  if (!handle || handle->between) return false;
  chooseCorner(handle->corner);
  return true;
}

bool SelectTool::isOnEdge(const ToolEvent& event) const {
  std::size_t corner = 0;
  return withCornerAdded(document(), event.position, event.reach(kHitPx), corner).has_value();
}

bool SelectTool::removeChosen() {
  if (!chosenCorner()) return false;
  removeChosenCorner();
  return true;
}

bool SelectTool::addCornerAt(const Vec2& position, double reach) {
  std::size_t corner = 0;
  const auto change = withCornerAdded(document(), position, reach, corner);
  if (!change) return false;
  document().apply(*change, tr("Add Corner"));
  chooseCorner(corner);
  return true;
}

bool SelectTool::addCornerBehindChosen() {
  const auto corner = chosenCorner();
  if (!corner) return false;
  const CornerLine line = *selectedCorners(document());
  const std::size_t edge = std::min(*corner, line.edgeCount() - 1);
  return line.corners.size() > 1 && addCornerAt(positionOf(line, {edge, true}), 0.01);
}

bool SelectTool::removeChosenCorner() {
  const auto corner = chosenCorner();
  const auto change = corner ? withCornerRemoved(document(), *corner) : std::nullopt;
  if (!change) return false;
  corner_.reset();
  document().apply(*change, tr("Delete Corner"));
  return true;
}

bool SelectTool::stepThroughCorners(int by) {
  const auto line = selectedCorners(document());
  if (!line) return false;
  const auto count = static_cast<int>(line->corners.size());
  const auto corner = chosenCorner();
  const int next = corner ? (static_cast<int>(*corner) + by + count) % count : 0;
  chooseCorner(static_cast<std::size_t>(next));
  return true;
}

// --- Keys

bool SelectTool::key(const ToolKey& key) {
  if (pressed_) return false;
  const bool at_corner = chosenCorner().has_value();
  if (const auto direction = directionOf(key.key))
    return nudge(*direction * key.step_m * (key.modifiers & Qt::ShiftModifier ? 10.0 : 1.0));
  switch (key.key) {
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      if (at_corner) return removeChosenCorner();
      if (document().selection().isEmpty()) return false;
      document().removeSelected();
      return true;
    case Qt::Key_Insert:
      return addCornerBehindChosen();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return stepThroughCorners(1);
    case Qt::Key_Tab:
      return at_corner ? stepThroughCorners(1) : stepThroughObjects(1);
    case Qt::Key_Backtab:
      return at_corner ? stepThroughCorners(-1) : stepThroughObjects(-1);
    default:
      return false;
  }
}

bool SelectTool::nudge(const Vec2& step) {
  if (const auto corner = chosenCorner()) {
    const Vec2 to = selectedCorners(document())->corners[*corner] + step;
    const auto change = withCornerMoved(document(), {*corner}, to);
    if (change) document().apply(*change, tr("Move Corner"), true);
    return true;
  }
  const MapChange objects = movable(document().map(), document().selection());
  if (objects.isEmpty()) return !document().selection().isEmpty();
  document().apply(moved(objects, step), tr("Nudge"), true);
  return true;
}

/// From the last object on, Tab leaves the canvas, as it leaves every other part of the window.
bool SelectTool::stepThroughObjects(int by) {
  const QStringList keys = allKeys(document().map());
  const qsizetype current = keys.indexOf(document().selection().value(0));
  const qsizetype next = current < 0 ? (by > 0 ? 0 : keys.size() - 1) : current + by;
  const bool is_one = next >= 0 && next < keys.size();
  document().setSelection(is_one ? QStringList{keys[next]} : QStringList());
  return is_one;
}

void SelectTool::updateCursor(const ToolEvent& event) {
  Qt::CursorShape shape = Qt::ArrowCursor;
  const auto line = selectedCorners(document());
  const Building* building = onlyBuilding(document());
  if (line && cornerHandleAt(*line, event)) {
    shape = Qt::CrossCursor;
  } else if (building && !building->flags.locked) {
    const Rectangle frame = handleFrame(*building, event.metres_per_pixel);
    if (const auto handle = handleAt(frame, event.position, event.metres_per_pixel))
      shape = cursorOf(frame, *handle);
    else if (distanceTo(building->footprint(), event.position) <= event.reach(kHitPx))
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
  const Building* building = onlyBuilding(document());
  if (building && !building->flags.locked)
    paintHandles(canvas, handleFrame(*building, canvas.metresPerPixel()));
  const Map& map = document().map();
  if (document().selection() == QStringList{kStartKey})
    paintHandle(canvas, startHandle(*map.start, canvas.metresPerPixel()), true);
  if (const auto line = selectedCorners(document())) paintCorners(canvas, *line, chosenCorner());
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
  const Building& building = preview_->buildings.front();
  if (drag_->corner) {
    const Polygon outline = building.footprint();
    const Vec2& corner = outline[std::min(*drag_->corner, outline.size() - 1)];
    paintOutline(canvas, outline, true, refused_ ? Role::Problem : Role::Preview);
    paintNote(canvas, canvas.toDevice(corner) + QPointF(0.0, 26.0), positionText(corner));
    return;
  }
  const Rectangle box = building.box();
  const Vec2 handle = handlePosition(box, {}, canvas.metresPerPixel());
  if (drag_->readout == Readout::Size) paintSizes(canvas, box);
  if (drag_->readout == Readout::Heading)
    paintNote(canvas, canvas.toDevice(handle), degreesText(box.heading));
  if (drag_->readout == Readout::Position)
    paintNote(canvas, canvas.toDevice(handle), positionText(box.centre));
}

}  // namespace handmap
