// A stereo camera: one device that gives both images side by side, or two devices.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/rig/rig.h"
#include "core/rig/rig_clock.h"
#include "drivers/camera/frame_check.h"
#include "drivers/camera/frame_grabber.h"
#include "drivers/device/device.h"

namespace handmap {

class VideoCamera : public PairCamera {
  Q_OBJECT
  Q_DISABLE_COPY_MOVE(VideoCamera)
 public:
  /// How one of its devices is opened; `begin_s`: when the camera was.
  using Devices = std::function<OpenImageDevice(const std::string& source, double begin_s)>;

  /// `refused` is told why an image was not used, in the thread of this object. `devices`: other
  /// ones than the rig names.
  VideoCamera(CameraRig rig, RigClock clock, std::function<void(const std::string&)> refused,
              Devices devices = {});
  ~VideoCamera() override;

  void open() override;
  /// Waits for the threads of the cameras: as long as a camera takes for an image.
  void close() override;

 private:
  struct Arrived {
    Side side;
    TimedImage frame;
  };
  std::unique_ptr<FrameGrabber> grabber(Side side, const std::string& source);
  void arrive(Side side, TimedImage frame);
  void takeArrived();
  void use(Side side, TimedImage frame);
  void giveHalves(const TimedImage& frame);
  void giveMatched(Side side, TimedImage frame);
  void tell(Side side, FrameGrabber::State state, const std::string& detail);
  void setState(DeviceState state, const std::string& detail);

  CameraRig rig_;
  RigClock clock_;
  double begin_s_ = 0.0;  ///< when it was opened
  Devices devices_;
  std::function<void(const std::string&)> refused_;
  PairMatcher matcher_;
  FrameCheck checks_[2];
  DeviceState state_ = DeviceState::Closed;
  std::string detail_;
  long unmatched_ = 0;
  int without_pair_ = 0;  ///< images in a row
  std::mutex mutex_;
  std::vector<Arrived> arrived_;  ///< under mutex_
  std::vector<std::unique_ptr<FrameGrabber>> grabbers_;
};

}  // namespace handmap
