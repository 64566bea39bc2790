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
#include "widgets/canvas/tools/corner_handles.h"
#include "widgets/canvas/tools/edge_rectangle_tool.h"
#include "widgets/canvas/tools/eraser_tool.h"
#include "widgets/canvas/tools/freehand_tool.h"
#include "widgets/canvas/tools/landmark_tool.h"
#include "widgets/canvas/tools/measure_tool.h"
#include "widgets/canvas/tools/polygon_tool.h"
#include "widgets/canvas/tools/rectangle_tool.h"
#include "widgets/canvas/tools/robot_pose_tool.h"
#include "widgets/canvas/tools/route_tool.h"
#include "widgets/canvas/tools/select_tool.h"
#include "widgets/canvas/tools/start_tool.h"
#include "widgets/canvas/underlay_item.h"
#include "widgets/pictures/picture_tool.h"

namespace handmap {

namespace {

constexpr double kMinScale = 1e-3;  // pixels per metre
constexpr double kMaxScale = 400.0;
constexpr double kMaxFitScale = 40.0;
constexpr double kZoomStep = 1.4;
/// Room to pan beyond every coordinate of a map; at kMaxScale it still fits Qt's integer scrolling.
constexpr double kReach = 1.5 * kMaxCoordinate;
constexpr QRectF kNothingDrawn(-50.0, -50.0, 100.0, 100.0);

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
  makeTools();
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    underlays_->rebuild();
    doubt_->rebuild();
    drawing_->rebuild();
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

template <typename ToolType, typename... Arguments>
ToolType* MapCanvas::addTool(Arguments&&... arguments) {
  auto tool = std::make_unique<ToolType>(document_, std::forward<Arguments>(arguments)...);
  ToolType* added = tool.get();
  connect(added, &Tool::changed, this, &MapCanvas::onToolChanged);
  connect(added, &Tool::created, name_, &NameEditor::arm);
  connect(added, &Tool::finished, this, [this] { setTool(ToolId::Select); });
  tools_.push_back(std::move(tool));
  return added;
}

void MapCanvas::makeTools() {
  tool_ = select_ = addTool<SelectTool>();
  addTool<RectangleTool>();
  addTool<EdgeRectangleTool>();
  addTool<PolygonTool>();
  freehand_ = addTool<FreehandTool>();
  addTool<StartTool>();
  addTool<RouteTool>();
  addTool<LandmarkTool>();
  addTool<MeasureTool>();
  eraser_ = addTool<EraserTool>();
  picture_tool_ =
      addTool<PictureTool>([this](std::size_t place) { return underlays_->sizeOf(place); });
  const auto* robot_pose = addTool<RobotPoseTool>();
  connect(robot_pose, &RobotPoseTool::given, this, [this](const Pose2& pose) {
    setTool(ToolId::Select);
    Q_EMIT robotPoseGiven(pose);
  });
  connect(select_, &SelectTool::renameRequested, this, [this](const QString& key) {
    document_.setSelection({key});
    renameSelected();
  });
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
    name_->placeAt(viewportTransform().map(toRect(*bounds).center()));
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
  if (id == tool_->id()) return;
  tool_->cancel();
  name_->disarm();
  before_eraser_ = nullptr;
  snap_ = {};
  tool_ = std::ranges::find(tools_, id, [](const auto& tool) { return tool->id(); })->get();
  tool_->activate();
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

void MapCanvas::setRecognizing(bool on) { freehand_->setRecognizing(on); }

// --- What is selected

void MapCanvas::deleteSelected() {
  if (tool_ == select_ && select_->chosenCorner())
    select_->removeChosenCorner();
  else
    document_.removeSelected();
}

void MapCanvas::renameSelected() {
  const QString key = document_.selection().value(0);
  if (document_.selection().size() != 1 || !nameOf(document_.map(), key)) return;
  name_->begin(key);
  layOut();
}

bool MapCanvas::canAddCorner() const {
  const Building* building = onlyBuilding(document_);
  return (building && !building->fixed) ||
         (document_.selection() == QStringList{kRouteKey} && document_.map().route.size() > 1);
}

void MapCanvas::addCorner() {
  if (!canAddCorner()) return;
  setTool(ToolId::Select);
  constexpr double kReachPx = 12.0;
  const auto at = std::exchange(menu_at_, std::nullopt);
  if (at && select_->addCornerAt(toMetres(*at), kReachPx / pixelsPerMetre())) return;
  if (select_->addCornerBehindChosen()) return;
  // Otherwise in the middle of the longest wall.
  const Building* building = onlyBuilding(document_);
  const CornerLine line =
      building ? CornerLine{building->footprint(), true} : CornerLine{document_.map().route, false};
  std::size_t longest = 0;
  const auto length = [&](std::size_t edge) {
    return (line.corners[(edge + 1) % line.corners.size()] - line.corners[edge]).norm();
  };
  for (std::size_t i = 1; i < line.edgeCount(); ++i)
    if (length(i) > length(longest)) longest = i;
  select_->addCornerAt(positionOf(line, {longest, true}), 0.01);
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
  if (!bounds) return;
  Q_EMIT movedByHand();
  setTurn(0.0);
  const QRectF box = toRect(*bounds);
  const double around = std::max(5.0, 0.5 * std::max(box.width(), box.height()));
  zoomToRect(box.adjusted(-around, -around, around, around));
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

void MapCanvas::setDoubtVisible(bool visible) { doubt_->setVisible(visible); }

void MapCanvas::setUnderlaysVisible(bool visible) { underlays_->setVisible(visible); }

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
  if (tool_->snapContext() && (tool_->isBusy() || tool_ == select_)) paintSnap(canvas, snap_);
  paintScaleBar(*painter, std::hypot(to_device.m11(), to_device.m12()), deviceArea(to_device),
                *colours_);
  painter->restore();
}

}  // namespace handmap
