// Everything drawn by the person, as one item of the scene, whatever the number of buildings.
#pragma once

#include <QGraphicsItem>
#include <QHash>
#include <QSet>
#include <optional>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "widgets/canvas/still_picture.h"
#include "widgets/canvas/tool.h"
#include "widgets/style/colours.h"

namespace handmap {

class DrawingItem : public QGraphicsItem {
 public:
  explicit DrawingItem(const MapDocument& document);

  void follow(const Touched& touched);
  void reselect();  ///< what is selected is another
  /// Shown in place of the objects of the same ids; nullptr: nothing.
  void setPreview(const MapChange* preview);
  void setColours(const Colours& colours);
  /// A way that is drawn must not read as planned where a robot drives: it is shown where it is
  /// selected or edited alone.
  void setRouteShown(bool shown);
  /// By id: where labels stand in place of the drawn outlines.
  void setLabelOutlines(const QHash<QString, QPolygonF>& outlines);

  QRectF boundingRect() const override { return bounds_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;
  /// Ids and names, over whatever else is shown. The painter is in device pixels; `exposed` in
  /// metres.
  void paintLabels(QPainter& painter, const QTransform& to_device, const QRectF& exposed) const;

 private:
  struct Shape {
    std::variant<Rectangle, Polygon> of;
    std::string id;
    std::string name;
    bool fixed = false;
    bool locked = false;
    QPolygonF outline;  ///< metres
    QRectF bounds;
    mutable std::optional<QPointF> middle;  ///< of its label; told when one is painted
    bool selected = false;
    bool off = false;     ///< hidden by the person
    bool hidden = false;  ///< a preview stands in its place

    bool shows(const Building& building) const;
  };
  using Shapes = std::vector<const Shape*>;

  Shape shapeOf(const Building& building) const;
  const LayerState& layer(DrawingLayer which) const { return stateOf(layers_, which); }
  void updateBounds();
  void showPreviewed();
  void hide(const std::string& id, bool hidden);
  void takeBuilding(std::size_t place);
  void forgetStills();
  Shapes visible(const QRectF& exposed) const;  ///< without what is previewed
  Shapes previewedIn(const QRectF& exposed) const;
  void paintBuildings(QPainter& painter, const Shapes& shapes, const QTransform& to_device) const;
  void paintLabels(QPainter& painter, const Shapes& shapes, const QTransform& to_device) const;
  void paintLabel(QPainter& painter, const Shape& shape, const QTransform& to_device) const;
  void paintLandmarkLabels(QPainter& painter, const QTransform& to_device) const;
  const Landmark& shown(const Landmark& on_map) const;
  void paintSigns(QPainter& painter, const QTransform& to_device) const;

  const MapDocument& document_;
  const Colours* colours_ = &Colours::light();
  std::vector<Shape> shapes_;
  std::vector<Shape> previewed_;
  std::unordered_map<std::string, std::size_t> places_;
  QHash<QString, QPolygonF> label_outlines_;
  MapChange preview_;
  bool route_shown_ = true;
  LayerStates layers_;
  QSet<QString> selected_;
  QRectF drawn_;  ///< around shapes_, or wider
  QRectF bounds_;
  // What a tool does not move: a drag paints it once.
  StillPicture still_;
  mutable StillPicture still_labels_;
};

}  // namespace handmap
