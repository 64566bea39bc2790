#include "widgets/canvas/canvas_snapping.h"

#include <QPainter>
#include <QSet>
#include <unordered_set>

#include "widgets/canvas/symbols.h"
#include "widgets/style/colours.h"

namespace handmap {

namespace {

constexpr double kNeighbourhood = 25.0;  // of the reach: walls within it lend their lines
constexpr std::size_t kMostWalls = 400;
constexpr double kSignPx = 5.0;

QString nameOf(SnapKind kind) {
  switch (kind) {
    case SnapKind::Corner:
      return QObject::tr("corner");
    case SnapKind::Crossing:
      return QObject::tr("crossing");
    case SnapKind::Wall:
      return QObject::tr("wall");
    case SnapKind::RightAngle:
      return QObject::tr("right angle");
    case SnapKind::Line:
      return QObject::tr("in line");
    case SnapKind::Grid:
    case SnapKind::None:
      return {};
  }
  return {};
}

Bounds around(const Vec2& point, double reach) {
  return {point.array() - reach, point.array() + reach};
}

}  // namespace

void CanvasSnapping::cycle() {
  if (modes_.objects)
    modes_ = modes_.grid ? SnapModes{false, false} : SnapModes{true, false};
  else
    modes_ = modes_.grid ? SnapModes{true, true} : SnapModes{false, true};
}

QString CanvasSnapping::modeName() const {
  if (modes_.grid && modes_.objects) return QObject::tr("Snap: objects, grid");
  if (modes_.grid) return QObject::tr("Snap: grid");
  if (modes_.objects) return QObject::tr("Snap: objects");
  return QObject::tr("Snap: off");
}

/// Those under the pointer or a moved corner before those that only lend their lines.
std::vector<Segment> CanvasSnapping::wallsAround(const SnapContext& context, const Vec2& pointer,
                                                 double reach) const {
  std::vector<Bounds> areas = {around(pointer, reach)};
  for (const Vec2& corner : context.moved_corners)
    areas.push_back(around(corner + pointer - context.grip, reach));
  areas.push_back(around(pointer, kNeighbourhood * reach));

  const QSet<QString> ignored(context.ignored.begin(), context.ignored.end());
  std::unordered_set<std::size_t> seen;
  std::vector<Segment> walls;
  for (const Bounds& area : areas) {
    for (const std::size_t i : document_.buildingIndex().touching(area)) {
      if (walls.size() >= kMostWalls) return walls;
      const Building& building = document_.map().buildings[i];
      if (!seen.insert(i).second || ignored.contains(QString::fromStdString(building.id))) continue;
      const Polygon outline = building.footprint();
      for (std::size_t k = 0; k < outline.size(); ++k)
        walls.push_back({outline[k], outline[(k + 1) % outline.size()]});
    }
  }
  return walls;
}

Snap CanvasSnapping::snap(const Vec2& pointer, double reach,
                          const std::optional<SnapContext>& context, bool held_off) const {
  const SnapModes modes = held_off ? SnapModes{false, false} : modes_;
  const Snapper snapper({modes.grid, modes.objects && context}, reach, kGridStep);
  if (!context || !modes.objects) return snapper.snap(pointer, {});
  SnapCandidates candidates{wallsAround(*context, pointer, reach), context->from, context->along};
  if (context->moved_corners.empty()) return snapper.snap(pointer, candidates);
  Snap snap = snapper.snapOffset(context->moved_corners, pointer - context->grip, candidates);
  snap.point += context->grip;
  return snap;
}

void paintSnap(ToolPaint& canvas, const Snap& snap) {
  const QString name = nameOf(snap.kind);
  if (name.isEmpty()) return;
  QPainter& painter = canvas.painter;
  painter.setPen(QPen(canvas.colours[Role::Selection], 1.0, Qt::DotLine));
  for (const Segment& guide : snap.guides)
    painter.drawLine(canvas.toDevice(guide.a), canvas.toDevice(guide.b));
  const QPointF at = canvas.toDevice(snap.guides.empty() ? snap.point : snap.guides.front().b);
  painter.setPen(QPen(canvas.colours[Role::Selection], 2.0));
  painter.setBrush(Qt::NoBrush);
  const QRectF sign(at - QPointF(kSignPx, kSignPx), at + QPointF(kSignPx, kSignPx));
  if (snap.kind == SnapKind::Corner) {
    painter.drawRect(sign);
  } else if (snap.kind == SnapKind::Crossing) {
    painter.drawLine(sign.topLeft(), sign.bottomRight());
    painter.drawLine(sign.topRight(), sign.bottomLeft());
  } else if (snap.kind == SnapKind::RightAngle) {
    painter.drawPolyline(QPolygonF{{sign.topLeft(), sign.bottomLeft(), sign.bottomRight()}});
  } else {
    painter.drawEllipse(sign);
  }
  paintLabel(painter, at + QPointF(0.0, -18.0), name, canvas.colours, true);
}

}  // namespace handmap
