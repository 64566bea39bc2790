#include "core/rendering/render_options.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/geometry/pose2.h"

namespace handmap {

namespace {

void requireWithin(double value, double low, double high, const std::string& what) {
  if (value >= low && value <= high) return;  // not a NaN either
  throwBadInput(phrase("rendering"), what, formatNumber(value),
                phrase("{} to {}", formatNumber(low), formatNumber(high)));
}

}  // namespace

StereoCamera cameraOf(const RenderOptions& options) {
  requireWithin(options.width, 64, 4096, phrase("width"));
  requireWithin(options.height, 64, 4096, phrase("height"));
  requireWithin(options.horizontal_fov_deg, 10, 150, phrase("field of view"));
  requireWithin(options.baseline_m, 0.01, 5, phrase("baseline"));
  requireWithin(options.mount.x, -10, 10, phrase("camera x"));
  requireWithin(options.mount.y, -10, 10, phrase("camera y"));
  requireWithin(options.mount.z, 0.2, 20, phrase("camera height"));
  requireWithin(toDegrees(options.mount.pitch), -60, 60, phrase("camera pitch"));
  requireWithin(options.mount.yaw, -4 * kPi, 4 * kPi, phrase("camera yaw"));
  requireWithin(options.noise_sigma, 0, 100, phrase("noise"));
  requireWithin(options.exposure, 0.01, 100, phrase("exposure"));
  requireWithin(options.light.sun_azimuth_deg, -1e4, 1e4, phrase("azimuth of the sun"));
  requireWithin(options.light.sun_elevation_deg, 5, 90, phrase("elevation of the sun"));
  requireWithin(options.light.sun, 0, 3, phrase("strength of the sun"));
  requireWithin(options.light.cloud_share, 0, 1, phrase("share of the clouds"));
  requireWithin(options.light.cloud_period_s, 0.1, 1e6, phrase("period of the clouds"));
  StereoCamera camera;
  camera.fx = camera.fy =
      options.width / 2.0 / std::tan(toRadians(options.horizontal_fov_deg) / 2.0);
  camera.cx = (options.width - 1) / 2.0;
  camera.cy = (options.height - 1) / 2.0;
  camera.baseline = options.baseline_m;
  camera.mount = options.mount;
  return camera;
}

}  // namespace handmap
