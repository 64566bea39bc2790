// Keeps the robot in the middle of the canvas while a run is shown, with the map upright or turned
// so that the robot looks up.
#pragma once

#include <QObject>
#include <optional>

#include "core/geometry/pose2.h"

namespace handmap {

class MapCanvas;

class FollowRobot : public QObject {
  Q_OBJECT
 public:
  enum class Mode { Off, Follow, FollowAndTurn };

  /// Whoever moves the view by hand ends it.
  explicit FollowRobot(MapCanvas& canvas, QObject* parent = nullptr);

  Mode mode() const { return mode_; }
  void setMode(Mode mode);
  void next();  ///< off, follow, follow and turn, off

  /// Where the robot is shown.
  void setPose(const Pose2& pose);
  void forgetPose() { pose_.reset(); }

 Q_SIGNALS:
  void modeChanged(handmap::FollowRobot::Mode mode);

 private:
  void follow();

  MapCanvas& canvas_;
  Mode mode_ = Mode::Off;
  std::optional<Pose2> pose_;
};

}  // namespace handmap
