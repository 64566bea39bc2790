// Tools of the canvas: small classes driven by the project's own events, so that tests need no
// window. A tool previews live and changes the document once, when it is done.
#pragma once

#include <QObject>
#include <QPointingDevice>
#include <QTransform>
#include <Qt>
#include <cmath>

#include "widgets/document/map_document.h"

class QPainter;

namespace handmap {

class Colours;

enum class ToolId { Select, Rectangle, Corners, Start, Route, Landmark, RobotPose, Picture };

/// A pointer event in the map frame.
struct ToolEvent {
  Vec2 position = Vec2::Zero();  ///< metres
  Vec2 snapped = Vec2::Zero();   ///< on the snap grid, or to the centimetre without one
  double metres_per_pixel = 0.1;
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double pressure = 1.0;  ///< 0 … 1
  QPointingDevice::PointerType pointer = QPointingDevice::PointerType::Generic;
};

struct ToolKey {
  int key = 0;  ///< Qt::Key
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  double step_m = 1.0;  ///< how far an arrow key moves
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
  virtual void press(const ToolEvent&) {}
  virtual void move(const ToolEvent&) {}  ///< with and without a button held
  virtual void release(const ToolEvent&) {}
  virtual void doubleClick(const ToolEvent& event) { press(event); }
  virtual bool key(const ToolKey&) { return false; }  ///< true when the tool used it

  /// What is drawn in place of the document's objects while the tool is at work.
  virtual const MapChange* preview() const { return nullptr; }
  virtual void paint(ToolPaint&) const {}

 Q_SIGNALS:
  void changed();  ///< preview, hint or cursor

 protected:
  MapDocument& document() const { return document_; }

 private:
  MapDocument& document_;
};

}  // namespace handmap
