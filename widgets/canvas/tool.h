// Tools of the canvas: small classes driven by the project's own events, so that tests need no
// window. A tool previews live and changes the document once, when it is done.
#pragma once

#include <QObject>
#include <QPointingDevice>
#include <QTransform>
#include <Qt>
#include <cmath>

#include "core/sketching/snapping.h"
#include "widgets/document/map_document.h"

class QPainter;

namespace handmap {

class Colours;

enum class ToolId {
  Select,
  Rectangle,
  EdgeRectangle,
  Corners,
  Freehand,
  Start,
  Route,
  Landmark,
  Measure,
  Eraser,
  RobotPose,
  Picture,
  GeoPin,
  Paper
};

/// A pointer event in the map frame.
struct ToolEvent {
  Vec2 position = Vec2::Zero();  ///< metres
  Vec2 snapped = Vec2::Zero();   ///< where the canvas draws it to; to the centimetre at least
  double metres_per_pixel = 0.1;
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double pressure = 1.0;  ///< 0 … 1
  QPointingDevice::PointerType pointer = QPointingDevice::PointerType::Generic;

  /// How far from a thing still counts as on it, metres: fingers are coarse.
  double reach(double pixels) const {
    const bool coarse = pointer == QPointingDevice::PointerType::Finger;
    return pixels * metres_per_pixel * (coarse ? 2.5 : 1.0);
  }
  bool isNear(const Vec2& point, double pixels) const {
    return (point - position).norm() <= reach(pixels);
  }
};

struct ToolKey {
  int key = 0;  ///< Qt::Key
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double step_m = 1.0;  ///< how far an arrow key moves what is selected
  QString text = {};
  double stride_m = 1.0;     ///< how far an arrow key moves the keyboard's own cursor
  Vec2 home = Vec2::Zero();  ///< where that cursor begins
  double metres_per_pixel = 0.1;
};

/// What the canvas may draw the pointer to while a tool is at work.
struct SnapContext {
  std::vector<Vec2> from = {};           ///< right angles about these
  std::optional<Vec2> along = {};        ///< the way of the edge before
  QStringList ignored = {};              ///< objects that are being changed
  std::vector<Vec2> moved_corners = {};  ///< what is dragged as a whole fits with one of these
  Vec2 grip = Vec2::Zero();              ///< where it was gripped
};

/// What a tool paints with: a painter in device pixels and the way there from the map frame.
struct ToolPaint {
  QPainter& painter;
  const QTransform& to_device;
  const Colours& colours;

  QPointF toDevice(const Vec2& point) const { return to_device.map(QPointF(point.x(), point.y())); }
  double metresPerPixel() const { return 1.0 / std::hypot(to_device.m11(), to_device.m12()); }
};

class Tool : public QObject {
  Q_OBJECT
 public:
  explicit Tool(MapDocument& document) : document_(document) {}

  virtual ToolId id() const = 0;
  virtual QString hint() const = 0;
  virtual Qt::CursorShape cursor() const { return Qt::CrossCursor; }

  virtual void activate() {}
  /// Drops what is begun; true when something was. Also called when another tool takes over.
  virtual bool cancel() { return false; }
  /// A second finger has come: what the first one did was no stroke. What was placed before stays.
  virtual void interrupt() { cancel(); }
  virtual void press(const ToolEvent&) {}
  virtual void move(const ToolEvent&) {}  ///< with and without a button held
  virtual void release(const ToolEvent&) {}
  virtual void doubleClick(const ToolEvent& event) { press(event); }
  virtual bool key(const ToolKey&) { return false; }  ///< true when the tool used it

  /// Whether something is begun, whether it can be finished as it is, and whether its last step can
  /// be taken back: what the buttons on the canvas offer.
  virtual bool isBusy() const { return false; }
  virtual bool canFinish() const { return false; }
  virtual bool canTakeBack() const { return false; }
  virtual void finish() {}
  virtual void takeBack() {}
  /// Whether a character is meant for the tool, and no shortcut.
  virtual bool wants(QChar) const { return false; }
  /// Whether a part of what is selected lies there, a corner say; it is chosen then.
  virtual bool chooseAt(const ToolEvent&) { return false; }
  /// Whether a part was chosen: it goes, where what is left may stay.
  virtual bool removeChosen() { return false; }
  /// Where the keyboard's cursor is, when it is in use.
  virtual std::optional<Vec2> keyboardCursor() const { return std::nullopt; }
  /// Nothing: the pointer is only rounded.
  virtual std::optional<SnapContext> snapContext() const { return std::nullopt; }

  /// What is drawn in place of the document's objects while the tool is at work.
  virtual const MapChange* preview() const { return nullptr; }
  virtual void paint(ToolPaint&) const {}

 Q_SIGNALS:
  void changed();                    ///< preview, hint or cursor
  void created(const QString& key);  ///< what is typed next is its name
  void finished();                   ///< the person is done with the tool

 protected:
  MapDocument& document() const { return document_; }

 private:
  MapDocument& document_;
};

}  // namespace handmap
