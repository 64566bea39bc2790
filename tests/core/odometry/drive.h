// What the stereo camera of a robot sees in a rendered yard.
#pragma once

#include "core/recording/observation.h"
#include "tests/core/perception/rendered_scene.h"

namespace handmap::test {

/// On a mount that is neither in the middle nor level.
inline StereoCamera odometryCamera() {
  StereoCamera camera = streetCamera();
  camera.mount = {0.4, 0.2, 1.5, toRadians(4.0), toRadians(-6.0)};
  return camera;
}

inline Scene yard() {
  return {{{{{2, 9}, {30, 9}}, 7.0}, {{{5, -7}, {28, -7}}, 6.0}, {{{32, -9}, {32, 11}}, 9.0}}, 0.0};
}

/// The images of the robot at `pose` in the scene.
inline View viewFrom(const Scene& scene, const Pose2& pose, double pan = 0.0) {
  StereoCamera camera = odometryCamera();
  const Vec2 place = pose.toOuter({camera.mount.x, camera.mount.y});
  camera.mount.x = place.x();
  camera.mount.y = place.y();
  const StereoPair pair = render(scene, camera, pose.heading + pan);
  return {pan, pair.left, pair.right, {}};
}

}  // namespace handmap::test
