// IIDC stereo heads on FireWire: Point Grey's Bumblebee 2 and XB3, the paper's camera. Both images
// of a pair (all three of an XB3) come in one frame, byte by byte in turn.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/rig/rig_clock.h"
#include "drivers/camera/image_device.h"

namespace handmap {

struct IidcFrame {
  const std::uint8_t* bytes = nullptr;  ///< until done()
  int width = 0;
  int height = 0;
  int images = 0;      ///< bytes a pixel: 2 or 3 images
  double age_s = 0.0;  ///< since it was taken
  bool damaged = false;
};

/// What is asked of libdc1394; a fake takes its place in tests. All of it throws Error, in plain
/// words, for what does not work.
class IidcCamera {
 public:
  virtual ~IidcCamera() = default;
  virtual std::vector<std::uint64_t> identities() = 0;
  /// The camera begins to send.
  virtual void begin(std::uint64_t identity) = 0;
  virtual std::uint32_t bayerRegister() = 0;
  /// nullopt: none yet. Each is to be given back by done() before the next.
  virtual std::optional<IidcFrame> poll() = 0;
  virtual void done() = 0;
};
using OpenIidc = std::function<std::unique_ptr<IidcCamera>()>;

/// Gives left and right side by side. `source`: the number of the camera, 16 hexadecimal digits, or
/// "first". A frame that was damaged on the way is left out; after 2 s without one it is lost.
OpenImageDevice iidcDevice(std::string source, OpenIidc open, RigClock clock);
/// The sources that are there.
std::vector<std::string> iidcCameras(IidcCamera& camera);

#ifdef HANDMAP_IIDC
std::unique_ptr<IidcCamera> systemIidc();
#endif

}  // namespace handmap
