// One of the two cameras at one time, in the map frame.
#pragma once

#include "core/geometry/pose2.h"
#include "core/recording/camera.h"
#include "core/rendering/surface.h"

namespace handmap {

/// The ray of pixel (u, v), with 1 along the optical axis, is
/// forward + (u - cx) / fx · right + (v - cy) / fy · down.
struct ViewCamera {
  Vec3 eye;
  Vec3 forward;
  Vec3 right;
  Vec3 down;
  double fx = 1.0;
  double fy = 1.0;
  double cx = 0.0;
  double cy = 0.0;
  int width = 0;
  int height = 0;

  Vec3 ray(double u, double v) const {
    return forward + (u - cx) / fx * right + (v - cy) / fy * down;
  }
};

/// The left camera of a robot at `pose`; the right one stands the baseline along `right`.
inline ViewCamera viewCamera(const StereoCamera& camera, int width, int height, const Pose2& pose,
                             double pan) {
  const CameraMount& mount = camera.mount;
  const Vec2 place = pose.toOuter({mount.x, mount.y});
  const Vec2 heading = unitVector(pose.heading + mount.yaw + pan);
  const double c = std::cos(mount.pitch);
  const double s = std::sin(mount.pitch);
  ViewCamera view;
  view.eye = {place.x(), place.y(), mount.z};
  view.forward = {c * heading.x(), c * heading.y(), -s};
  view.right = {heading.y(), -heading.x(), 0.0};
  view.down = {-s * heading.x(), -s * heading.y(), -c};
  view.fx = camera.fx;
  view.fy = camera.fy;
  view.cx = camera.cx;
  view.cy = camera.cy;
  view.width = width;
  view.height = height;
  return view;
}

}  // namespace handmap
