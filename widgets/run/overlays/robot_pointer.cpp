#include "widgets/run/overlays/robot_pointer.h"

#include <QEvent>
#include <QPainter>
#include <QScrollBar>

#include "widgets/canvas/map_canvas.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

namespace {

constexpr int kButtonPx = 34;
constexpr int kFromEdgePx = 8;

}  // namespace

RobotPointer::RobotPointer(MapCanvas& canvas) : QAbstractButton(&canvas), canvas_(canvas) {
  setObjectName("robot_pointer");
  setFixedSize(kButtonPx, kButtonPx);
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::NoFocus);
  setToolTip(tr("The robot is out of view: click to go there"));
  setAccessibleName(toolTip());
  hide();
  canvas.viewport()->installEventFilter(this);
  connect(&canvas, &MapCanvas::scaleChanged, this, &RobotPointer::place);
  connect(&canvas, &MapCanvas::turned, this, &RobotPointer::place);
  for (const QScrollBar* bar : {canvas.horizontalScrollBar(), canvas.verticalScrollBar()})
    connect(bar, &QScrollBar::valueChanged, this, &RobotPointer::place);
  connect(this, &QAbstractButton::clicked, this, [this] {
    if (!pose_) return;
    Q_EMIT canvas_.movedByHand();
    canvas_.centreAt(toScene(pose_->position()));
  });
}

void RobotPointer::setPose(const std::optional<Pose2>& pose) {
  pose_ = pose;
  place();
}

void RobotPointer::place() {
  const QRectF shown = canvas_.viewport()->rect();
  const QPointF at =
      pose_ ? canvas_.viewportTransform().map(toScene(pose_->position())) : shown.center();
  setVisible(!shown.contains(at));
  if (isHidden()) return;
  const double margin = kFromEdgePx + kButtonPx / 2.0;
  const QRectF edge = shown.adjusted(margin, margin, -margin, -margin);
  const QPointF to = at - shown.center();
  angle_ = std::atan2(to.y(), to.x());
  const QPointF centre(std::clamp(at.x(), edge.left(), std::max(edge.left(), edge.right())),
                       std::clamp(at.y(), edge.top(), std::max(edge.top(), edge.bottom())));
  move((centre - QPointF(width() / 2.0, height() / 2.0)).toPoint());
  // What else lies on the canvas is clicked as well.
  for (const auto* other : canvas_.findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
    if (other == this || other == canvas_.viewport() || other->isHidden()) continue;
    const QRect taken = other->geometry();
    if (!geometry().intersects(taken)) continue;
    move(x(), to.y() < 0.0 ? taken.bottom() + 1 : taken.top() - height());
  }
  raise();
  update();
}

bool RobotPointer::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) place();
  return QAbstractButton::eventFilter(watched, event);
}

void RobotPointer::paintEvent(QPaintEvent*) {
  static const QPolygonF kArrow({{13.0, 0.0}, {-7.0, 9.0}, {-2.5, 0.0}, {-7.0, -9.0}});
  const Colours& colours = Colours::of(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(width() / 2.0, height() / 2.0);
  painter.rotate(toDegrees(angle_));
  painter.setPen(QPen(colours[Role::TextHalo], 2.0));
  painter.setBrush(colours[Role::Trajectory]);
  painter.drawPolygon(kArrow);
}

}  // namespace handmap
