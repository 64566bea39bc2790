// The one canvas for drawing and for watching.
#pragma once

#include <QGraphicsView>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/canvas/tool.h"

namespace handmap {

class DoubtItem;
class DrawingItem;
class PictureTool;
class UnderlayItem;

/// Heights of the layers in the scene; the overlays of a run lie between drawing and tool.
inline constexpr double kUnderlayZ = -100.0;
inline constexpr double kDrawingZ = 0.0;
inline constexpr double kOverlayZ = 100.0;

/// Scene coordinates are metres of the map frame, y up; the view flips. scene() takes overlays.
class MapCanvas : public QGraphicsView {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(MapCanvas)
 public:
  explicit MapCanvas(MapDocument& document, QWidget* parent = nullptr);
  ~MapCanvas() override;

  // --- Tools
  ToolId tool() const;
  void setTool(ToolId id);
  QString hint() const;
  PictureTool& pictureTool() { return *picture_tool_; }
  /// Metres; 0: no snapping.
  double snapStep() const { return snap_step_; }
  void setSnapStep(double step_m) { snap_step_ = step_m; }

  // --- View
  double pixelsPerMetre() const;
  void zoomAt(QPointF viewport_position, double factor);
  void zoomIn();
  void zoomOut();
  void zoomToFit();                       ///< everything drawn, or 100 m around the origin
  void zoomToRect(const QRectF& metres);  ///< with a margin
  void zoomToObject(const QString& key);  ///< of the document; nothing when it is not there
  QRectF visibleMetres() const;
  /// How the map is turned on the screen, radians, counter-clockwise; where the middle is it stays.
  double turn() const { return turn_; }
  void setTurn(double turn_rad);
  void centreAt(QPointF metres);

  // --- Layers
  bool isGridVisible() const { return grid_visible_; }
  void setGridVisible(bool visible);
  void setDrawingVisible(bool visible);
  void setDrawingOpacity(double share);
  /// By id: outlines of buildings to write their labels into, in place of the drawn ones.
  void setLabelOutlines(const QHash<QString, QPolygonF>& outlines);
  void setUnderlaysVisible(bool visible);
  void setDoubtVisible(bool visible);

 Q_SIGNALS:
  void cursorMoved(QPointF metres);
  void scaleChanged(double pixels_per_metre);
  void toolChanged(handmap::ToolId id);
  void hintChanged(const QString& hint);
  void turned(double turn_rad);
  /// Somebody wants to see another place: by hand, or one object or all of the map.
  void movedByHand();
  /// Somebody says that the robot is there, at the moment that is shown.
  void robotPoseGiven(const handmap::Pose2& pose);

 protected:
  bool viewportEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void drawBackground(QPainter* painter, const QRectF& rect) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void makeTools();
  void applyPalette();
  void escape();
  ToolEvent toolEvent(const QMouseEvent& event) const;
  void onToolChanged();
  void updateCursor();
  void panBy(QPointF pixels);
  QRectF deviceArea(const QTransform& to_device) const;
  void setView(double pixels_per_metre, QPointF metres, QPointF viewport_position);

  MapDocument& document_;
  QGraphicsScene* scene_;
  UnderlayItem* underlays_;
  DoubtItem* doubt_;
  DrawingItem* drawing_;
  std::vector<std::unique_ptr<Tool>> tools_;
  Tool* tool_ = nullptr;
  PictureTool* picture_tool_ = nullptr;
  const Colours* colours_;
  double snap_step_ = 0.0;
  double turn_ = 0.0;
  bool grid_visible_ = true;
  bool space_held_ = false;
  bool fitted_ = true;  ///< as zoomToFit() left it: stays so when the canvas gets another size
  std::optional<QPointF> pan_from_;
};

}  // namespace handmap
