// The one canvas for drawing and for watching.
#pragma once

#include <QBasicTimer>
#include <QElapsedTimer>
#include <QGraphicsView>
#include <QLineF>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "widgets/canvas/canvas_snapping.h"
#include "widgets/canvas/tool.h"

class QTabletEvent;
class QTouchEvent;

namespace handmap {

class CanvasChips;
class DoubtItem;
class DrawingItem;
class NameEditor;
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
  /// Until the first one comes, the canvas only shows.
  void addTool(std::unique_ptr<Tool> tool);
  ToolId tool() const;
  void setTool(ToolId id);
  QString hint() const;
  Tool& currentTool() { return *tool_; }
  void finishTool();
  SnapModes snapModes() const { return snapping_.modes(); }
  void setSnapModes(SnapModes modes);
  void cycleSnapModes();

  // --- What is selected
  void deleteSelected();  ///< the chosen corner, or the objects
  void renameSelected();  ///< in place; nothing where not one building or landmark is selected
  /// Where the context menu was opened that has just been chosen from; once.
  std::optional<Vec2> takeMenuPlace();
  /// Where something that is pasted goes: under the pointer, or in the middle of what is shown.
  Vec2 pastePosition() const;

  /// Asked where nothing drawn lies: the id of the corrected building there; empty: none.
  void setCorrectedAt(std::function<QString(const Vec2& metres)> at) {
    corrected_at_ = std::move(at);
  }

  // --- View
  double pixelsPerMetre() const;
  void zoomAt(QPointF viewport_position, double factor);
  void zoomIn();
  void zoomOut();
  void zoomToFit();                       ///< everything drawn, or 100 m around the origin
  void zoomToRect(const QRectF& metres);  ///< with a margin
  void zoomToObject(const QString& key);  ///< of the document; nothing when it is not there
  void zoomToArea(const QRectF& metres);  ///< with what is around it
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
  /// While a run is shown the drawn route is not, unless somebody works on it.
  void setRunShown(bool shown);
  void setUnderlaysVisible(bool visible);
  QSize pictureSize(std::size_t place) const;  ///< pixels of the picture underneath
  void setDoubtVisible(bool visible);

 Q_SIGNALS:
  void cursorMoved(QPointF metres);
  void scaleChanged(double pixels_per_metre);
  void toolChanged(handmap::ToolId id);
  void hintChanged(const QString& hint);
  void turned(double turn_rad);
  /// Somebody wants to see another place: by hand, or one object or all of the map.
  void movedByHand();
  void snapModesChanged();
  /// What it is about is selected.
  void contextMenuRequested(QPoint global);

 protected:
  bool event(QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void timerEvent(QTimerEvent* event) override;
  void leaveEvent(QEvent* event) override;
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
  Tool* toolOf(ToolId id) const;  ///< nullptr: there is none
  void makeOverlays();
  void layOut();  ///< what lies on the canvas
  void applyPalette();
  void escape();
  bool giveKey(const QKeyEvent& event);
  ToolEvent toolEvent(QPointF viewport_position, Qt::KeyboardModifiers modifiers);
  ToolEvent toolEvent(const QMouseEvent& event);
  void press(const ToolEvent& event);
  bool selectCorrected(const ToolEvent& event);
  void showMenuAt(QPointF viewport_position);
  bool takeTouch(QTouchEvent& event);
  void beginTouch(const ToolEvent& event, QPointF at);
  void endTouch(const ToolEvent& event, QPointF at);
  void moveByTwo(const QTouchEvent& event);
  bool takeEraser(QTabletEvent& event);
  Vec2 toMetres(QPointF viewport_position) const;
  void keepInSight(const Vec2& point);
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
  Tool* tool_;
  bool run_shown_ = false;
  Tool* before_eraser_ = nullptr;  ///< while the other end of a pen erases
  CanvasChips* chips_ = nullptr;
  NameEditor* name_ = nullptr;
  std::function<QString(const Vec2& metres)> corrected_at_ = [](const Vec2&) { return QString(); };
  CanvasSnapping snapping_;
  Snap snap_;  ///< of the last event
  const Colours* colours_;
  double turn_ = 0.0;
  bool grid_visible_ = true;
  bool space_held_ = false;
  bool fitted_ = true;  ///< as zoomToFit() left it: stays so when the canvas gets another size
  std::optional<QPointF> pan_from_;
  std::optional<QPointF> pointer_;   ///< in the viewport, while it is there
  std::optional<QPointF> menu_at_;   ///< in the viewport, where a context menu was opened
  bool cancelled_by_press_ = false;  ///< no menu after it
  enum class Fingers { None, One, Two, Done };
  Fingers fingers_ = Fingers::None;
  QPointF touched_at_;
  std::optional<QLineF> two_at_;  ///< the two fingers, when last heard of
  QPointF tapped_at_;
  QElapsedTimer since_tap_;
  QBasicTimer long_press_;
};

}  // namespace handmap
