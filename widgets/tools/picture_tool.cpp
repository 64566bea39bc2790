#include "widgets/tools/picture_tool.h"

#include <QLocale>
#include <QSize>
#include <algorithm>

#include "core/map/map_limits.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kTurnStep = toRadians(0.5);  // of an arrow key
constexpr double kScaleStep = 1.01;
constexpr double kLeastScale = 1e-6;  // metres per pixel
constexpr qsizetype kMostDigits = 12;

constexpr std::array<Handle, 4> kCorners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
constexpr Handle kTurn{0, 0};

/// Scaled and turned about a point of the map.
Underlay changedAbout(const Underlay& underlay, const Vec2& fixed, double factor, double turn) {
  const Vec2 arm = Vec2(underlay.x, underlay.y) - fixed;
  const Vec2 corner = fixed + factor * Pose2{0.0, 0.0, turn}.toOuter(arm);
  Underlay result = underlay;
  result.x = corner.x();
  result.y = corner.y();
  result.metres_per_pixel *= factor;
  result.heading = normalizedAngle(result.heading + turn);
  return result;
}

}  // namespace

PictureTool::PictureTool(MapDocument& document, SizeOf size_of)
    : Tool(document), size_of_(std::move(size_of)) {
  const auto forget = [this] {
    if (!points_.empty() && !current()) cancel();
  };
  connect(&document, &MapDocument::mapChanged, this, forget);
}

QString PictureTool::hint() const {
  if (document().map().underlays.empty())
    return tr("There is no picture yet: Draw / Add Picture Underneath…, or drop one here");
  if (!current()) return tr("This picture is locked · Layers unlocks it");
  switch (mode_) {
    case Mode::Place:
      return tr(
          "Drag to move · corners scale, the round handle turns · arrow keys move, with Ctrl "
          "they turn and scale");
    case Mode::Scale:
      if (points_.size() < 2) return tr("Click two points whose distance you know");
      return tr("Type the distance in metres, then Enter · Esc: other points");
    case Mode::Fit:
      if (points_.size() % 2 == 1) return tr("Now click where this point belongs on the map");
      if (pairs() < 2) return tr("Click a point in the picture, then where it belongs on the map");
      return tr("Enter fits the picture · a third pair makes it surer · Backspace: one point back");
  }
  return {};
}

void PictureTool::activate() {
  const auto place = current();
  if (place && document().selection() != QStringList{pictureKey(*place)})
    document().setSelection({pictureKey(*place)});
}

void PictureTool::setMode(Mode mode) {
  cancel();
  mode_ = mode;
  Q_EMIT changed();
}

bool PictureTool::cancel() {
  const bool was_busy = isBusy();
  pressed_ = false;
  grip_.reset();
  preview_.reset();
  points_.clear();
  typed_.clear();
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void PictureTool::interrupt() {
  pressed_ = false;
  grip_.reset();
  preview_.reset();
  Q_EMIT changed();
}

std::optional<std::size_t> PictureTool::current() const {
  const std::vector<Underlay>& underlays = document().map().underlays;
  if (underlays.empty()) return std::nullopt;
  const auto selected = pictureIndex(document().selection().value(0));
  const std::size_t place = selected ? *selected : underlays.size() - 1;
  const bool can =
      place < underlays.size() && !underlays[place].flags.locked && !underlays[place].flags.hidden;
  return can ? std::optional(place) : std::nullopt;
}

Rectangle PictureTool::boxOf(std::size_t place) const {
  const auto& list = preview_ ? *preview_->underlays : document().map().underlays;
  const Underlay& underlay = list[place];
  const QSize size = size_of_(place);
  const Vec2 middle(size.width() / 2.0, size.height() / 2.0);
  return {pointOf(underlay, middle), size.width() * underlay.metres_per_pixel,
          size.height() * underlay.metres_per_pixel, underlay.heading};
}

std::optional<PictureTool::Grip> PictureTool::gripAt(const ToolEvent& event) const {
  const auto place = current();
  if (!place) return std::nullopt;
  const Underlay underlay = document().map().underlays[*place];
  const Rectangle box = boxOf(*place);
  const double scale = event.metres_per_pixel;
  if (event.isNear(handlePosition(box, kTurn, scale), kHandleReachPx)) {
    return Grip{[underlay, box](const ToolEvent& to) {
                  const double step = to.modifiers & Qt::ShiftModifier ? 15.0 : 0.1;
                  return changedAbout(underlay, box.centre, 1.0,
                                      turned(box, to.position, step).heading - box.heading);
                },
                tr("Turn Picture")};
  }
  for (const Handle& handle : kCorners) {
    if (!event.isNear(handlePosition(box, handle, scale), kHandleReachPx)) continue;
    const Vec2 opposite = handlePosition(box, {-handle.along, -handle.across}, scale);
    const Vec2 diagonal = handlePosition(box, handle, scale) - opposite;
    return Grip{[underlay, opposite, diagonal](const ToolEvent& to) {
                  const double share =
                      (to.position - opposite).dot(diagonal) / diagonal.squaredNorm();
                  return changedAbout(underlay, opposite, std::max(share, 0.01), 0.0);
                },
                tr("Scale Picture")};
  }
  if (!contains(box.corners(), event.position)) return std::nullopt;
  return Grip{[underlay, from = event.position](const ToolEvent& to) {
                Underlay moved = underlay;
                moved.x += to.position.x() - from.x();
                moved.y += to.position.y() - from.y();
                return moved;
              },
              tr("Move Picture")};
}

void PictureTool::change(std::size_t place, const Underlay& underlay, const QString& text,
                         bool mergeable) {
  std::vector<Underlay> list = document().map().underlays;
  list[place] = underlay;
  Underlay& placed = list[place];  // no further than a file may say
  placed.metres_per_pixel = std::clamp(placed.metres_per_pixel, kLeastScale, kMaxMetresPerPixel);
  placed.x = std::clamp(placed.x, -kMaxCoordinate, kMaxCoordinate);
  placed.y = std::clamp(placed.y, -kMaxCoordinate, kMaxCoordinate);
  document().setUnderlays(std::move(list), text, mergeable);
}

void PictureTool::press(const ToolEvent& event) {
  if (!current()) return;
  pressed_ = mode_ != Mode::Place;
  if (!pressed_) grip_ = gripAt(event);
}

void PictureTool::move(const ToolEvent& event) {
  pointer_ = event.position;
  const auto place = current();
  if (grip_ && place) {
    preview_ = MapChange{.underlays = document().map().underlays};
    (*preview_->underlays)[*place] = grip_->change(event);
  } else {
    const auto under = mode_ == Mode::Place ? gripAt(event) : std::nullopt;
    cursor_ = mode_ != Mode::Place ? Qt::CrossCursor : under ? Qt::SizeAllCursor : Qt::ArrowCursor;
    if (mode_ == Mode::Place) return;
  }
  Q_EMIT changed();
}

void PictureTool::release(const ToolEvent& event) {
  if (std::exchange(pressed_, false) && current()) return addPoint(event);
  if (!grip_) return;
  move(event);
  const auto place = current();
  const auto grip = std::exchange(grip_, std::nullopt);
  const auto result = std::exchange(preview_, std::nullopt);
  if (place && result) change(*place, (*result->underlays)[*place], grip->text, false);
  Q_EMIT changed();
}

// --- Points

void PictureTool::addPoint(const ToolEvent& event) {
  const Underlay& underlay = document().map().underlays[*current()];
  if (mode_ == Mode::Scale && points_.size() == 2) points_.clear();
  const bool on_picture = mode_ == Mode::Fit && points_.size() % 2 == 0;
  points_.push_back(on_picture             ? pixelOf(underlay, event.position)
                    : mode_ == Mode::Scale ? event.position
                                           : event.snapped);
  pointer_ = event.position;
  Q_EMIT changed();
}

std::optional<double> PictureTool::measured() const {
  if (mode_ != Mode::Scale || points_.size() < 2) return std::nullopt;
  return (points_[1] - points_[0]).norm();
}

bool PictureTool::setLength(double length_m) {
  const auto place = current();
  if (!place || !measured()) return false;
  const auto result = scaled(document().map().underlays[*place], points_[0], points_[1], length_m);
  if (!result) return false;
  change(*place, *result, tr("Scale Picture"), false);
  cancel();
  return true;
}

bool PictureTool::fit() {
  const auto place = current();
  if (!place || mode_ != Mode::Fit) return false;
  std::vector<PointPair> known;
  for (std::size_t i = 0; i < pairs(); ++i) known.push_back({points_[2 * i], points_[2 * i + 1]});
  const auto result = fitted(document().map().underlays[*place], known);
  if (!result) return false;
  change(*place, result->underlay, tr("Fit Picture"), false);
  cancel();
  return true;
}

// --- Keys

bool PictureTool::key(const ToolKey& key) {
  if (!current()) return false;
  const bool is_enter = key.key == Qt::Key_Return || key.key == Qt::Key_Enter;
  if (is_enter && canFinish()) {
    finish();
    return true;
  }
  if (key.key == Qt::Key_Backspace && canTakeBack()) {
    takeBack();
    return true;
  }
  if (measured()) return typeLength(key);
  return nudge(key);
}

std::optional<double> PictureTool::typedLength() const {
  bool is_number = false;
  const double length = QLocale::c().toDouble(typed_, &is_number);
  return is_number && measured() ? std::optional(length) : std::nullopt;
}

bool PictureTool::canFinish() const {
  return current() && (mode_ == Mode::Fit ? pairs() >= 2 : typedLength().has_value());
}

void PictureTool::finish() {
  if (mode_ == Mode::Fit)
    fit();
  else if (const auto length = typedLength())
    setLength(*length);
}

void PictureTool::takeBack() {
  if (!typed_.isEmpty())
    typed_.chop(1);
  else if (!points_.empty())
    points_.pop_back();
  Q_EMIT changed();
}

bool PictureTool::wants(QChar character) const {
  return measured() && (character.isDigit() || character == u'.' || character == u',');
}

/// Where a point of the picture belongs is often a corner that is drawn.
std::optional<SnapContext> PictureTool::snapContext() const {
  const bool on_map = mode_ == Mode::Fit && points_.size() % 2 == 1;
  return on_map ? std::optional(SnapContext{}) : std::nullopt;
}

bool PictureTool::typeLength(const ToolKey& key) {
  if (key.key >= Qt::Key_0 && key.key <= Qt::Key_9 && typed_.size() < kMostDigits) {
    typed_ += QChar(key.key);
  } else if ((key.key == Qt::Key_Period || key.key == Qt::Key_Comma) && !typed_.contains(u'.')) {
    typed_ += u'.';
  } else {
    return false;
  }
  Q_EMIT changed();
  return true;
}

bool PictureTool::nudge(const ToolKey& key) {
  const int right = (key.key == Qt::Key_Right) - (key.key == Qt::Key_Left);
  const int up = (key.key == Qt::Key_Up) - (key.key == Qt::Key_Down);
  if (right == 0 && up == 0) return false;
  const std::size_t place = *current();
  Underlay underlay = document().map().underlays[place];
  if (key.modifiers & Qt::ControlModifier) {
    const Vec2 centre = boxOf(place).centre;
    underlay = changedAbout(underlay, centre, std::pow(kScaleStep, up), -right * kTurnStep);
  } else {
    const double step = key.step_m * (key.modifiers & Qt::ShiftModifier ? 10.0 : 1.0);
    underlay.x += right * step;
    underlay.y += up * step;
  }
  change(place, underlay, tr("Adjust Picture"), true);
  Q_EMIT changed();
  return true;
}

// --- Painting

void PictureTool::paint(ToolPaint& canvas) const {
  const auto place = current();
  if (!place) return;
  const Rectangle box = boxOf(*place);
  Polygon frame = box.corners();
  frame.push_back(frame.front());
  paintOutline(canvas, frame, false, Role::Preview);  // open, so that nothing tints the picture
  if (mode_ == Mode::Place) {
    const double scale = canvas.metresPerPixel();
    for (const Handle& handle : kCorners) paintHandle(canvas, handlePosition(box, handle, scale));
    paintHandle(canvas, handlePosition(box, kTurn, scale), true);
    if (grip_) paintSizes(canvas, box);
  } else {
    paintPoints(canvas);
  }
}

void PictureTool::paintPoints(ToolPaint& canvas) const {
  const Underlay& underlay = document().map().underlays[*current()];
  std::vector<Vec2> on_map = points_;
  if (mode_ == Mode::Fit)
    for (std::size_t i = 0; i < on_map.size(); i += 2) on_map[i] = pointOf(underlay, on_map[i]);
  const bool lacks_end = on_map.size() % 2 == 1;
  if (lacks_end) on_map.push_back(pointer_);
  for (std::size_t i = 0; i + 1 < on_map.size(); i += 2) {
    const Vec2 leg[] = {on_map[i], on_map[i + 1]};
    paintOutline(canvas, leg, false, Role::Preview);
    paintHandle(canvas, leg[0], true);
    paintHandle(canvas, leg[1]);
    const QPointF middle = canvas.toDevice(0.5 * (leg[0] + leg[1])) + QPointF(0.0, -20.0);
    if (mode_ == Mode::Fit)
      paintNote(canvas, middle, QString::number(i / 2 + 1));
    else if (typed_.isEmpty())
      paintNote(canvas, middle, metresText((leg[1] - leg[0]).norm()));
    else
      paintNote(canvas, middle, QStringLiteral("%1_ m").arg(typed_));
  }
}

}  // namespace handmap
