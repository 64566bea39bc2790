#include "widgets/tools/freehand_tool.h"

#include <QPainter>

#include "core/map/map_limits.h"
#include "widgets/canvas/building_handles.h"
#include "widgets/tools/tool_painting.h"

namespace handmap {

namespace {

constexpr double kResolutionPx = 2.0;

QString nameOf(const ShapeGuess& guess) {
  switch (guess.kind) {
    case StrokeShape::Rectangular:
      return QObject::tr("Rectangle");
    case StrokeShape::LShaped:
      return QObject::tr("L-shape");
    case StrokeShape::Polygonal:
      return QObject::tr("Polygon of %1 corners").arg(guess.outline.size());
  }
  return {};
}

Vec2 tidy(const Vec2& point) { return roundedTo(point, Snapper::kTidy); }

/// On whole centimetres and tenths of a degree, as whatever else is drawn.
Building withShape(Building building, const ShapeGuess& guess) {
  if (guess.kind == StrokeShape::Rectangular) {
    const Rectangle& box = guess.rectangle;
    const Vec2 size = tidy({box.width, box.depth}).cwiseMax(kMinSize);
    building.shape =
        Rectangle{tidy(box.centre), size.x(), size.y(), roundedHeading(box.heading, 0.1)};
    return building;
  }
  Polygon outline = guess.outline;
  for (Vec2& corner : outline) corner = tidy(corner);
  building.shape = isSimple(outline) ? outline : guess.outline;
  return building;
}

}  // namespace

QString FreehandTool::hint() const {
  if (isGuessing())
    return tr("Enter: take it as %1 · Tab: something else · Esc: leave it as drawn")
        .arg(nameOf(*guess()));
  if (too_small_) return tr("Draw once around the building");
  return tr("Draw around a building in one stroke");
}

const ShapeGuess* FreehandTool::guess() const {
  if (guesses_.empty() || !document().map().find(of_.toStdString())) return nullptr;
  return &guesses_[shown_];
}

bool FreehandTool::cancel() {
  const bool was_busy = isBusy();
  stroke_.clear();
  guesses_.clear();
  too_small_ = false;
  if (was_busy) Q_EMIT changed();
  return was_busy;
}

void FreehandTool::interrupt() {
  stroke_.clear();
  Q_EMIT changed();
}

void FreehandTool::press(const ToolEvent& event) {
  finish();  // who draws on is content with the guess
  stroke_ = {event.position};
  too_small_ = false;
  Q_EMIT changed();
}

void FreehandTool::move(const ToolEvent& event) {
  if (stroke_.empty() || stroke_.back() == event.position) return;
  stroke_.push_back(event.position);
  Q_EMIT changed();
}

void FreehandTool::release(const ToolEvent& event) {
  if (stroke_.empty()) return;
  move(event);
  addStroke(event.reach(kResolutionPx));
  Q_EMIT changed();
}

void FreehandTool::addStroke(double resolution) {
  const Polygon stroke = std::move(stroke_);
  stroke_.clear();
  Polygon outline = strokeOutline(stroke, resolution / 2.0);
  std::vector<ShapeGuess> guesses = recognizedShapes(stroke, resolution);
  too_small_ = guesses.empty() || outline.empty() || outline.size() > kMaxPolygonVertices;
  if (too_small_) return;
  Building building;
  building.shape = std::move(outline);
  of_ = document().addBuilding(std::move(building));
  document().setSelection({of_});
  guesses_.clear();
  shown_ = 0;
  if (recognizing_) guesses_ = std::move(guesses);
  Q_EMIT created(of_);
}

void FreehandTool::showNextGuess(int by) {
  const auto count = static_cast<int>(guesses_.size());
  shown_ = static_cast<std::size_t>((static_cast<int>(shown_) + by + count) % count);
  Q_EMIT changed();
}

void FreehandTool::finish() {
  const ShapeGuess* taken = guess();
  if (!taken) return;
  const Building* building = document().map().find(of_.toStdString());
  const Building changed_building = withShape(*building, *taken);
  const QString text = tr("Straighten to %1").arg(nameOf(*taken));
  guesses_.clear();
  document().changeBuilding(of_, changed_building, text);
  Q_EMIT created(of_);
  Q_EMIT changed();
}

void FreehandTool::takeBack() {
  if (!isGuessing()) return;
  guesses_.clear();
  document().remove({of_});
  Q_EMIT changed();
}

bool FreehandTool::key(const ToolKey& key) {
  if (!isGuessing()) return false;
  switch (key.key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      finish();
      return true;
    case Qt::Key_Tab:
      showNextGuess();
      return true;
    case Qt::Key_Backtab:
      showNextGuess(-1);
      return true;
    case Qt::Key_Backspace:
      takeBack();
      return true;
    default:
      return false;
  }
}

void FreehandTool::paint(ToolPaint& canvas) const {
  if (!stroke_.empty()) paintOutline(canvas, stroke_, false, Role::Preview);
  if (!isGuessing()) return;
  paintOutline(canvas, guess()->outline, true, Role::Selection);
  const Bounds bounds = boundsOf(guess()->outline);
  const Vec2 below((bounds.low.x() + bounds.high.x()) / 2.0, bounds.low.y());
  paintNote(
      canvas, canvas.toDevice(below) + QPointF(0.0, 20.0),
      QStringLiteral("%1  (%2/%3)").arg(nameOf(*guess())).arg(shown_ + 1).arg(guesses_.size()));
}

}  // namespace handmap
