// An arrow at the edge of the canvas towards a robot that is out of view; a click goes there.
#pragma once

#include <QAbstractButton>
#include <optional>

#include "core/geometry/pose2.h"

namespace handmap {

class MapCanvas;

class RobotPointer : public QAbstractButton {
  Q_OBJECT
 public:
  /// Lies over the canvas.
  explicit RobotPointer(MapCanvas& canvas);

  void setPose(const std::optional<Pose2>& pose);  ///< nullopt: no robot is shown

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void place();

  MapCanvas& canvas_;
  std::optional<Pose2> pose_;
  double angle_ = 0.0;  ///< on the screen, radians, clockwise from the right
};

}  // namespace handmap
