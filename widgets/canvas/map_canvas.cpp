#include "widgets/canvas/map_canvas.h"

#include <QEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "core/map/map_limits.h"
#include "widgets/canvas/canvas_chips.h"
#include "widgets/canvas/doubt_item.h"
#include "widgets/canvas/drawing_item.h"
#include "widgets/canvas/name_editor.h"
#include "widgets/canvas/rulers.h"
#include "widgets/canvas/underlay_item.h"

namespace handmap {

namespace {

constexpr double kMinScale = 1e-3;  // pixels per metre
constexpr double kMaxScale = 400.0;
constexpr double kMaxFitScale = 40.0;
constexpr double kZoomStep = 1.4;
/// Room to pan beyond every coordinate of a map; at kMaxScale it still fits Qt's integer scrolling.
constexpr double kReach = 1.5 * kMaxCoordinate;
constexpr QRectF kNothingDrawn(-50.0, -50.0, 100.0, 100.0);

/// Of a canvas that only shows.
class NoTool : public Tool {
 public:
  using Tool::Tool;
  ToolId id() const override { return ToolId::Select; }
  QString hint() const override { return {}; }
  Qt::CursorShape cursor() const override { return Qt::ArrowCursor; }
};

QRectF toRect(const Bounds& bounds) {
  const Vec2 size = bounds.high - bounds.low;
  return {bounds.low.x(), bounds.low.y(), size.x(), size.y()};
}

}  // namespace

MapCanvas::MapCanvas(MapDocument& document, QWidget* parent)
    : QGraphicsView(parent),
      document_(document),
      scene_(new QGraphicsScene(this)),
      underlays_(new UnderlayItem(document)),
      doubt_(new DoubtItem(document)),
      drawing_(new DrawingItem(document)),
      snapping_(document) {
  setScene(scene_);
  scene_->setSceneRect(-kReach, -kReach, 2.0 * kReach, 2.0 * kReach);
  scene_->setItemIndexMethod(QGraphicsScene::NoIndex);
  underlays_->setZValue(kUnderlayZ);
  drawing_->setZValue(kDrawingZ);
  scene_->addItem(underlays_);
  doubt_->setFlag(QGraphicsItem::ItemStacksBehindParent);
  doubt_->setParentItem(drawing_);  // is hidden with it
  scene_->addItem(drawing_);

  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setViewportUpdateMode(FullViewportUpdate);
  setTransformationAnchor(NoAnchor);
  setResizeAnchor(AnchorViewCenter);
  setOptimizationFlag(DontSavePainterState);
  setFocusPolicy(Qt::StrongFocus);
  viewport()->setMouseTracking(true);
  viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
  setAccessibleName(tr("Drawing"));

  makeOverlays();
  tools_.push_back(std::make_unique<NoTool>(document_));
  tool_ = tools_.back().get();
  connect(&document_, &MapDocument::mapChanged, this, [this](const Touched& touched) {
    if (touched.underlays) underlays_->rebuild();
    doubt_->follow(touched);
    drawing_->follow(touched);
    onToolChanged();
  });
  connect(&document_, &MapDocument::trustChanged, this, [this] { underlays_->reload(); });
  connect(&document_, &MapDocument::selectionChanged, this, [this] {
    drawing_->reselect();
    onToolChanged();
  });
  applyPalette();
  setView(5.0, QPointF(), viewport()->rect().center());
}

MapCanvas::~MapCanvas() = default;

void MapCanvas::addTool(std::unique_ptr<Tool> tool) {
  connect(tool.get(), &Tool::changed, this, &MapCanvas::onToolChanged);
  connect(tool.get(), &Tool::created, this, [this](const QString& key) {
    name_->arm(key);
    layOut();
  });
  connect(tool.get(), &Tool::finished, this, [this] { setTool(ToolId::Select); });
  const bool is_first = tools_.size() == 1;
  tools_.push_back(std::move(tool));
  if (!is_first) return;
  tool_ = tools_.back().get();
  onToolChanged();
}

Tool* MapCanvas::toolOf(ToolId id) const {
  const auto found = std::find_if(tools_.rbegin(), tools_.rend(),
                                  [id](const auto& tool) { return tool->id() == id; });
  return found == tools_.rend() ? nullptr : found->get();
}

void MapCanvas::makeOverlays() {
  name_ = new NameEditor(document_, this);
  chips_ = new CanvasChips(this);
  connect(chips_, &CanvasChips::doneRequested, this, &MapCanvas::finishTool);
  connect(chips_, &CanvasChips::backRequested, this, [this] { tool_->takeBack(); });
  connect(chips_, &CanvasChips::cancelRequested, this, [this] { tool_->cancel(); });
  connect(chips_, &CanvasChips::snapRequested, this, &MapCanvas::cycleSnapModes);
  chips_->setSnapText(snapping_.modeName());
}

void MapCanvas::layOut() {
  chips_->place();
  if (!name_->isOpen()) return;
  if (const auto bounds = boundsOf(document_.map(), name_->key()))
    name_->placeAt(viewportTransform().mapRect(toRect(*bounds)));
}

void MapCanvas::applyPalette() {
  colours_ = &Colours::of(palette());
  doubt_->setColours(*colours_);
  drawing_->setColours(*colours_);
  underlays_->setColours(*colours_);
  viewport()->update();
}

ToolId MapCanvas::tool() const { return tool_->id(); }

QString MapCanvas::hint() const { return tool_->hint(); }

void MapCanvas::setTool(ToolId id) {
  if (id == tool_->id() || toolOf(id) == nullptr) return;
  tool_->cancel();
  name_->disarm();
  before_eraser_ = nullptr;
  snap_ = {};
  tool_ = toolOf(id);
  tool_->activate();
  setRunShown(run_shown_);
  onToolChanged();
  Q_EMIT toolChanged(id);
}

void MapCanvas::finishTool() {
  if (tool_->canFinish()) tool_->finish();
}

void MapCanvas::setSnapModes(SnapModes modes) {
  if (modes == snapping_.modes()) return;
  snapping_.setModes(modes);
  chips_->setSnapText(snapping_.modeName());
  Q_EMIT snapModesChanged();
}

void MapCanvas::cycleSnapModes() {
  CanvasSnapping next = snapping_;
  next.cycle();
  setSnapModes(next.modes());
}

// --- What is selected

void MapCanvas::deleteSelected() {
  if (!tool_->removeChosen()) document_.removeSelected();
}

void MapCanvas::renameSelected() {
  const QString key = document_.selection().value(0);
  if (document_.selection().size() != 1 || !nameOf(document_.map(), key)) return;
  name_->begin(key);
  layOut();
}

std::optional<Vec2> MapCanvas::takeMenuPlace() {
  const auto at = std::exchange(menu_at_, std::nullopt);
  return at ? std::optional(toMetres(*at)) : std::nullopt;
}

Vec2 MapCanvas::pastePosition() const {
  if (menu_at_) return roundedTo(toMetres(*menu_at_), Snapper::kTidy);
  const QPointF at = pointer_.value_or(viewport()->rect().toRectF().center());
  return roundedTo(toMetres(at), Snapper::kTidy);
}

void MapCanvas::onToolChanged() {
  drawing_->setPreview(tool_->preview());
  underlays_->setPreview(tool_->preview());
  chips_->show(*tool_);
  if (tool_->isBusy()) name_->disarm();
  if (const auto cursor = tool_->keyboardCursor()) keepInSight(*cursor);
  updateCursor();
  viewport()->update();
  Q_EMIT hintChanged(tool_->hint());
}

// --- View

double MapCanvas::pixelsPerMetre() const {
  return std::hypot(transform().m11(), transform().m12());
}

void MapCanvas::setView(double pixels_per_metre, QPointF metres, QPointF viewport_position) {
  const double scale = std::clamp(pixels_per_metre, kMinScale, kMaxScale);
  setTransform(QTransform().rotateRadians(turn_) * QTransform::fromScale(scale, -scale));
  const QPointF off = viewportTransform().map(metres) - viewport_position;
  panBy(-off);
  layOut();
  Q_EMIT scaleChanged(scale);
}

void MapCanvas::setTurn(double turn_rad) {
  if (turn_ == turn_rad) return;
  const QPointF middle = viewport()->rect().toRectF().center();
  const QPointF metres = viewportTransform().inverted().map(middle);
  turn_ = turn_rad;
  setView(pixelsPerMetre(), metres, middle);
  Q_EMIT turned(turn_);
}

void MapCanvas::centreAt(QPointF metres) {
  panBy(viewport()->rect().toRectF().center() - viewportTransform().map(metres));
}

void MapCanvas::panBy(QPointF pixels) {
  fitted_ = false;
  const auto shift = [](QScrollBar* bar, double by) {
    bar->setValue(bar->value() - static_cast<int>(std::lround(by)));
  };
  shift(horizontalScrollBar(), pixels.x());
  shift(verticalScrollBar(), pixels.y());
  layOut();
}

void MapCanvas::keepInSight(const Vec2& point) {
  constexpr double kMarginPx = 40.0;
  const QRectF shown =
      viewport()->rect().toRectF().adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
  const QPointF at = viewportTransform().map(QPointF(point.x(), point.y()));
  if (shown.contains(at) || shown.isEmpty()) return;
  panBy({std::clamp(at.x(), shown.left(), shown.right()) - at.x(),
         std::clamp(at.y(), shown.top(), shown.bottom()) - at.y()});
}

void MapCanvas::zoomAt(QPointF viewport_position, double factor) {
  const QPointF metres = viewportTransform().inverted().map(viewport_position);
  setView(pixelsPerMetre() * factor, metres, viewport_position);
}

void MapCanvas::zoomIn() { zoomAt(viewport()->rect().toRectF().center(), kZoomStep); }

void MapCanvas::zoomOut() { zoomAt(viewport()->rect().toRectF().center(), 1.0 / kZoomStep); }

void MapCanvas::zoomToFit() {
  setTurn(0.0);
  QRectF all = underlays_->boundingRect();
  if (const auto drawn = boundsOf(document_.map())) all |= toRect(*drawn).adjusted(-2, -2, 2, 2);
  zoomToRect(all.isEmpty() ? kNothingDrawn : all);
  fitted_ = true;
}

void MapCanvas::zoomToRect(const QRectF& metres) {
  const QRectF shown = viewport()->rect();
  const double scale =
      0.88 * std::min(shown.width() / metres.width(), shown.height() / metres.height());
  setView(std::min(scale, kMaxFitScale), metres.center(), shown.center());
}

void MapCanvas::zoomToObject(const QString& key) {
  if (const auto picture = pictureIndex(key);
      picture && *picture < document_.map().underlays.size())
    return zoomToRect(underlays_->boundsOf(*picture));
  const auto bounds = boundsOf(document_.map(), key);
  if (bounds) zoomToArea(toRect(*bounds));
}

void MapCanvas::zoomToArea(const QRectF& metres) {
  Q_EMIT movedByHand();
  setTurn(0.0);
  const double around = std::max(5.0, 0.5 * std::max(metres.width(), metres.height()));
  zoomToRect(metres.adjusted(-around, -around, around, around));
}

QRectF MapCanvas::visibleMetres() const {
  return viewportTransform().inverted().mapRect(viewport()->rect().toRectF());
}

// --- Layers

void MapCanvas::setGridVisible(bool visible) {
  grid_visible_ = visible;
  viewport()->update();
}

void MapCanvas::setDrawingVisible(bool visible) { drawing_->setVisible(visible); }

void MapCanvas::setDrawingOpacity(double share) { drawing_->setOpacity(share); }

void MapCanvas::setLabelOutlines(const QHash<QString, QPolygonF>& outlines) {
  drawing_->setLabelOutlines(outlines);
  viewport()->update();
}

void MapCanvas::setRunShown(bool shown) {
  run_shown_ = shown;
  drawing_->setRouteShown(!shown || tool() == ToolId::Route);
}

void MapCanvas::setDoubtVisible(bool visible) { doubt_->setVisible(visible); }

void MapCanvas::setUnderlaysVisible(bool visible) { underlays_->setVisible(visible); }

QSize MapCanvas::pictureSize(std::size_t place) const { return underlays_->sizeOf(place); }

/// What is visible, where a painter paints it: here, or in a picture.
QRectF MapCanvas::deviceArea(const QTransform& to_device) const {
  const QPolygonF shown =
      viewportTransform().inverted().map(QPolygonF(viewport()->rect().toRectF()));
  return to_device.map(shown).boundingRect();
}

void MapCanvas::drawBackground(QPainter* painter, const QRectF&) {
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});
  const QRectF area = deviceArea(to_device);
  painter->fillRect(area, (*colours_)[Role::Background]);
  painter->setRenderHint(QPainter::Antialiasing, false);
  if (grid_visible_) paintGrid(*painter, to_device, area, *colours_);
  painter->restore();
}

void MapCanvas::drawForeground(QPainter* painter, const QRectF&) {
  painter->save();
  const QTransform to_device = painter->worldTransform();
  painter->setWorldTransform({});
  painter->setRenderHint(QPainter::Antialiasing);
  // What a run shows lies over the drawing, but not over the words.
  if (drawing_->isVisible()) drawing_->paintLabels(*painter, to_device, visibleMetres());
  ToolPaint canvas{*painter, to_device, *colours_};
  tool_->paint(canvas);
  if (tool_->snapContext() && (tool_->isBusy() || tool() == ToolId::Select))
    paintSnap(canvas, snap_);
  paintScaleBar(*painter, std::hypot(to_device.m11(), to_device.m12()), deviceArea(to_device),
                *colours_);
  painter->restore();
}

}  // namespace handmap
