#include "widgets/canvas/map_canvas.h"

#include <QEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>

#include "core/map/map_limits.h"
#include "widgets/canvas/doubt_item.h"
#include "widgets/canvas/drawing_item.h"
#include "widgets/canvas/rulers.h"
#include "widgets/canvas/tools/landmark_tool.h"
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
      drawing_(new DrawingItem(document)) {
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
  viewport()->grabGesture(Qt::PinchGesture);

  makeTools();
  connect(&document_, &MapDocument::mapChanged, this, [this] {
    underlays_->rebuild();
    doubt_->rebuild();
    drawing_->rebuild();
    onToolChanged();
  });
  connect(&document_, &MapDocument::trustChanged, this, [this] { underlays_->reload(); });
  connect(&document_, &MapDocument::selectionChanged, this, [this] {
    drawing_->rebuild();
    onToolChanged();
  });
  applyPalette();
  setView(5.0, QPointF(), viewport()->rect().center());
}

MapCanvas::~MapCanvas() = default;

void MapCanvas::makeTools() {
  tools_.push_back(std::make_unique<SelectTool>(document_));
  tools_.push_back(std::make_unique<RectangleTool>(document_));
  tools_.push_back(std::make_unique<PolygonTool>(document_));
  tools_.push_back(std::make_unique<StartTool>(document_));
  tools_.push_back(std::make_unique<RouteTool>(document_));
  tools_.push_back(std::make_unique<LandmarkTool>(document_));
  auto picture_tool = std::make_unique<PictureTool>(
      document_, [this](std::size_t place) { return underlays_->sizeOf(place); });
  picture_tool_ = picture_tool.get();
  tools_.push_back(std::move(picture_tool));
  auto robot_pose = std::make_unique<RobotPoseTool>(document_);
  connect(robot_pose.get(), &RobotPoseTool::given, this, [this](const Pose2& pose) {
    setTool(ToolId::Select);
    Q_EMIT robotPoseGiven(pose);
  });
  tools_.push_back(std::move(robot_pose));
  tool_ = tools_.front().get();
  for (const auto& tool : tools_)
    connect(tool.get(), &Tool::changed, this, &MapCanvas::onToolChanged);
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
  tool_ = std::ranges::find(tools_, id, [](const auto& tool) { return tool->id(); })->get();
  tool_->activate();
  onToolChanged();
  Q_EMIT toolChanged(id);
}

void MapCanvas::onToolChanged() {
  drawing_->setPreview(tool_->preview());
  underlays_->setPreview(tool_->preview());
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
  paintScaleBar(*painter, std::hypot(to_device.m11(), to_device.m12()), deviceArea(to_device),
                *colours_);
  painter->restore();
}

}  // namespace handmap
