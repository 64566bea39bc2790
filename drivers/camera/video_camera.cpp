#include "drivers/camera/video_camera.h"

#include <cmath>

#include "core/base/phrase.h"
#include "drivers/camera/image_devices.h"

namespace handmap {

namespace {

/// Images wait for the thread of the rig; when it does not come, the oldest go.
constexpr std::size_t kMostArrived = 8;
constexpr int kManyWithoutPair = 20;

std::size_t indexOf(Side side) { return side == Side::Left ? 0 : 1; }

}  // namespace

VideoCamera::VideoCamera(CameraRig rig, RigClock clock,
                         std::function<void(const std::string&)> refused, Devices devices)
    : rig_(std::move(rig)),
      clock_(std::move(clock)),
      devices_(std::move(devices)),
      refused_(std::move(refused)),
      matcher_(rig_.right_delay_s),
      checks_{FrameCheck({rig_.width, rig_.height}), FrameCheck({rig_.width, rig_.height})} {}

VideoCamera::~VideoCamera() { grabbers_.clear(); }

void VideoCamera::open() {
  if (!grabbers_.empty()) return;
  setState(DeviceState::Connecting, rig_.left);
  begin_s_ = clock_();
  grabbers_.push_back(grabber(Side::Left, rig_.left));
  if (!rig_.right.empty()) grabbers_.push_back(grabber(Side::Right, rig_.right));
}

void VideoCamera::close() {
  grabbers_.clear();
  setState(DeviceState::Closed, {});
}

std::unique_ptr<FrameGrabber> VideoCamera::grabber(Side side, const std::string& source) {
  OpenImageDevice open =
      devices_ ? devices_(source, begin_s_) : imageDevice(rig_, source, clock_, begin_s_);
  return std::make_unique<FrameGrabber>(
      source, std::move(open), indexOf(side) + 1,
      [this, side](TimedImage frame) { arrive(side, std::move(frame)); },
      [this, side](FrameGrabber::State state, const std::string& detail) {
        QMetaObject::invokeMethod(
            this, [this, side, state, detail] { tell(side, state, detail); }, Qt::QueuedConnection);
      });
}

/// In the thread of a grabber.
void VideoCamera::arrive(Side side, TimedImage frame) {
  bool first = false;
  {
    const std::scoped_lock lock(mutex_);
    first = arrived_.empty();
    if (arrived_.size() == kMostArrived) arrived_.erase(arrived_.begin());
    arrived_.push_back({side, std::move(frame)});
  }
  if (first) QMetaObject::invokeMethod(this, &VideoCamera::takeArrived, Qt::QueuedConnection);
}

void VideoCamera::takeArrived() {
  std::vector<Arrived> arrived;
  {
    const std::scoped_lock lock(mutex_);
    arrived.swap(arrived_);
  }
  for (Arrived& one : arrived) use(one.side, std::move(one.frame));
}

void VideoCamera::use(Side side, TimedImage frame) {
  if (grabbers_.empty()) return;  // closed meanwhile
  FrameCheck& check = checks_[indexOf(side)];
  const FrameFault fault = check(frame.image);
  if (fault == FrameFault::None) {
    return rig_.right.empty() ? giveHalves(frame) : giveMatched(side, std::move(frame));
  }
  refused_(nameOf(fault));
  if (fault == FrameFault::WrongSize) {
    setState(DeviceState::Degraded,
             phrase("found images of {} × {} pixels, expected {} × {}", frame.image.cols,
                    frame.image.rows, check.expected().width, check.expected().height));
  }
  if (check.repeatedInARow() >= kFrozen) {
    setState(DeviceState::Degraded, phrase("the image is frozen"));
  }
}

void VideoCamera::giveHalves(const TimedImage& frame) {
  const cv::Mat& image = frame.image;
  if (image.cols % 2 != 0) {
    refused_(phrase("image of an odd width"));
    return setState(DeviceState::Degraded,
                    phrase("found images {} pixels wide, expected an even width: two images "
                           "side by side",
                           image.cols));
  }
  const int width = image.cols / 2;
  cv::Mat left = image.colRange(0, width);
  cv::Mat right = image.colRange(width, image.cols);
  if (rig_.right_first) std::swap(left, right);
  setState(DeviceState::Ready, {});
  Q_EMIT pairTaken(frame.time_s, left, right);
}

void VideoCamera::giveMatched(Side side, TimedImage frame) {
  const auto pair = matcher_.add(side, std::move(frame));
  for (; unmatched_ < matcher_.unmatched(); ++unmatched_) {
    refused_(phrase("image without its pair"));
  }
  if (!pair) {
    if (++without_pair_ < kManyWithoutPair) return;
    return setState(DeviceState::Degraded,
                    phrase("left and right images never come together; right_delay_ms = {:.0f} "
                           "would fit, if it is always the same",
                           (matcher_.offset_s() + rig_.right_delay_s) * 1000.0));
  }
  without_pair_ = 0;
  if (pair->left.size() != pair->right.size()) {
    refused_(phrase("pair of images of two sizes"));
    return setState(DeviceState::Degraded, phrase("left and right images are of two sizes"));
  }
  setState(DeviceState::Ready, {});
  Q_EMIT pairTaken(pair->time_s, pair->left, pair->right);
}

void VideoCamera::tell(Side side, FrameGrabber::State state, const std::string& detail) {
  if (grabbers_.empty()) return;
  checks_[indexOf(side)] = FrameCheck({rig_.width, rig_.height});
  if (state == FrameGrabber::State::Opening && state_ != DeviceState::Lost) {
    setState(DeviceState::Connecting, detail);
  }
  if (state == FrameGrabber::State::Lost || state == FrameGrabber::State::AtEnd) {
    setState(DeviceState::Lost, detail);
  }
}

void VideoCamera::setState(DeviceState state, const std::string& detail) {
  if (state == state_ && detail == detail_) return;
  state_ = state;
  detail_ = detail;
  Q_EMIT stateChanged(state, QString::fromStdString(detail));
}

}  // namespace handmap
