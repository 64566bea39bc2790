// The stereo camera, the light and the noise of rendered images.
#pragma once

#include <cstdint>

#include "core/recording/camera.h"

namespace handmap {

/// Angles in degrees; the azimuth is that of the sun, counter-clockwise from the map's x axis.
struct Light {
  double sun_azimuth_deg = 230.0;
  double sun_elevation_deg = 38.0;
  double sun = 1.0;              ///< 0: overcast, 1: a clear day, up to 3: walls saturate
  double cloud_share = 0.3;      ///< 0 … 1: how much passing clouds take from the sun
  double cloud_period_s = 40.0;  ///< of the simulated clock
};

struct RenderOptions {
  int width = 640;
  int height = 480;
  double horizontal_fov_deg = 66.0;  ///< the paper's camera
  double baseline_m = 0.5;
  CameraMount mount{0.0, 0.0, 1.5, 0.0, 0.0};
  bool colour = false;
  double noise_sigma = 1.5;  ///< of the sensor, grey levels
  double exposure = 1.0;     ///< on top of the automatic one
  Light light;
};

/// Square pixels, principal point in the middle. Throws BadInput for what no camera can have:
/// 64–4096 pixels a side, 10–150° of view, baseline 0.01–5 m, height 0.2–20 m, pitch within 60°.
StereoCamera cameraOf(const RenderOptions& options);

}  // namespace handmap
