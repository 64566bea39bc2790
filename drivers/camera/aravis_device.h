// GigE Vision and USB3 Vision cameras through Aravis.
#pragma once

#include <string>
#include <vector>

#include "core/rig/rig_clock.h"
#include "drivers/camera/image_device.h"

namespace handmap {

struct AravisOptions {
  std::string source;  ///< as Aravis names it ("Basler-21234567"), or an IP address
  int width = 0;       ///< 0: as it likes
  int height = 0;
  double rate_hz = 0.0;
};

#ifdef HANDMAP_ARAVIS
/// Grey or Bayer, 8 bit. A camera that is silent for 2 s is lost; an image of which packets are
/// missing is left out.
OpenImageDevice aravisDevice(AravisOptions options, RigClock clock);
/// The sources that are there now; takes about a second.
std::vector<std::string> aravisCameras();
#endif

}  // namespace handmap
