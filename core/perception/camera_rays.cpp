#include "core/perception/camera_rays.h"

#include <cmath>

namespace handmap {

CameraRays::CameraRays(const StereoCamera& camera, cv::Size size) {
  const double c = std::cos(camera.mount.pitch);
  const double s = std::sin(camera.mount.pitch);
  for (int row = 0; row < size.height; ++row) {
    const double down = (row - camera.cy) / camera.fy;
    forward.push_back(c - s * down);
    up.push_back(-s - c * down);
  }
  for (int column = 0; column < size.width; ++column) {
    left.push_back((camera.cx - column) / camera.fx);
  }
}

StereoCamera reducedCamera(const StereoCamera& camera, double factor_x, double factor_y) {
  StereoCamera reduced = camera;
  reduced.fx /= factor_x;
  reduced.fy /= factor_y;
  // The centre of the first pixel is 0, its corner -0.5.
  reduced.cx = (camera.cx + 0.5) / factor_x - 0.5;
  reduced.cy = (camera.cy + 0.5) / factor_y - 0.5;
  return reduced;
}

}  // namespace handmap
