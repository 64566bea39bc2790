#include "widgets/run/overlays/follow_robot.h"

#include "widgets/canvas/map_canvas.h"
#include "widgets/run/overlays/scene_points.h"

namespace handmap {

FollowRobot::FollowRobot(MapCanvas& canvas, QObject* parent) : QObject(parent), canvas_(canvas) {
  connect(&canvas, &MapCanvas::movedByHand, this, [this] { setMode(Mode::Off); });
}

void FollowRobot::setMode(Mode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  if (mode_ != Mode::FollowAndTurn) canvas_.setTurn(0.0);  // one draws on an upright map
  follow();
  Q_EMIT modeChanged(mode_);
}

void FollowRobot::next() {
  switch (mode_) {
    case Mode::Off:
      return setMode(Mode::Follow);
    case Mode::Follow:
      return setMode(Mode::FollowAndTurn);
    case Mode::FollowAndTurn:
      return setMode(Mode::Off);
  }
}

void FollowRobot::setPose(const Pose2& pose) {
  pose_ = pose;
  follow();
}

void FollowRobot::follow() {
  if (mode_ == Mode::Off || !pose_) return;
  if (mode_ == Mode::FollowAndTurn) {
    canvas_.setTurn(normalizedAngle(kPi / 2.0 - pose_->heading));
  }
  // What is well in sight does not move the map.
  constexpr double kMarginPx = 40.0;
  const QRectF shown = canvas_.viewport()->rect();
  const QRectF inner = shown.adjusted(kMarginPx, kMarginPx, -kMarginPx, -kMarginPx);
  const bool in_sight = inner.contains(canvas_.viewportTransform().map(toScene(pose_->position())));
  if (mode_ == Mode::FollowAndTurn || !in_sight) canvas_.centreAt(toScene(pose_->position()));
}

}  // namespace handmap
