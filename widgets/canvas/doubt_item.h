// How unsure the drawing is: a soft edge as wide as what a run takes for the error of each wall, or
// as what a run whose correction was taken over has left of it;
// a question mark on what may not exist, and where the robot may start and look.
#pragma once

#include <QGraphicsItem>
#include <vector>

#include "widgets/canvas/still_picture.h"
#include "widgets/document/map_document.h"
#include "widgets/style/colours.h"

namespace handmap {

class DoubtItem : public QGraphicsItem {
 public:
  explicit DoubtItem(const MapDocument& document);

  void follow(const Touched& touched);
  void setColours(const Colours& colours);

  QRectF boundingRect() const override;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  struct Edge {
    QPolygonF outline;           ///< metres
    std::vector<double> sigmas;  ///< of each wall, metres
    bool may_not_exist;
  };

  void include(std::size_t place);
  std::vector<double> sigmasOf(const Building& building) const;
  void paintEdges(QPainter& painter, const QTransform& to_device, const QRectF& exposed) const;
  void paintStart(QPainter& painter, const QTransform& to_device) const;
  std::vector<Edge> edgesIn(const QRectF& exposed, double pixels_per_metre) const;

  const MapDocument& document_;
  const Colours* colours_ = &Colours::light();
  double reach_ = 0.0;  ///< the widest edge, metres
  bool any_may_not_exist_ = false;
  std::optional<StartUncertainty> start_;
  QRectF around_start_;
  QRectF buildings_;    ///< without their edges
  StillPicture still_;  ///< wide lines take long
};

}  // namespace handmap
