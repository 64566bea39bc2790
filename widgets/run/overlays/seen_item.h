// What the robot sees at the moment that is shown: the points, the walls that they lie on, or how
// far it looks. One item each.
#pragma once

#include <QGraphicsItem>
#include <QLineF>
#include <QList>
#include <QPolygonF>
#include <memory>

#include "core/explain/seen_walls.h"
#include "core/tape/tape.h"
#include "widgets/style/colours.h"

namespace handmap {

class SeenItem : public QGraphicsItem {
 public:
  enum class Part { Points, Walls, Sight };
  explicit SeenItem(Part part) : part_(part) {}

  void setColours(const Colours& colours);
  /// nullptr: nothing is known. It is put together when it is first painted.
  void setSeen(std::shared_ptr<const Perceived> seen, const Pose2& robot, double range_m);
  /// Map frame.
  void setWalls(const std::vector<SeenWall>& walls);

  static QPen wallPen(const Colours& colours);
  static QPen rangePen(const Colours& colours);
  static QBrush sightBrush(const Colours& colours);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void prepare();
  void paintPoints(QPainter& painter) const;
  void paintSight(QPainter& painter) const;

  Part part_;
  const Colours* colours_ = &Colours::light();
  std::shared_ptr<const Perceived> seen_;  ///< until it is painted
  double range_m_ = 0.0;
  QRectF bounds_;
  QPolygonF walls_seen_;  ///< returns that are surely of walls; robot frame, as those below
  QPolygonF others_;
  QPolygonF looked_through_;
  QList<QLineF> walls_;  ///< map frame
};

}  // namespace handmap
