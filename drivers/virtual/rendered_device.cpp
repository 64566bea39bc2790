#include "drivers/virtual/rendered_device.h"

#include <algorithm>
#include <utility>

#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kLate_s = 3.0;
constexpr double kHalf = 0.6;     // of the height that still comes
constexpr double kKept_s = 10.0;  // clouds pass and people walk
constexpr double kNoise = 1.0;    // grey levels

class RenderedDevice : public ImageDevice {
 public:
  RenderedDevice(const RenderedCamera& camera, std::shared_ptr<CameraPlace> place, RigClock clock)
      : camera_(camera),
        place_(std::move(place)),
        clock_(std::move(clock)),
        renderer_(camera.rendering, camera.seed),
        due_s_(clock_()),
        noise_(camera.seed) {
    if (fault() == FaultKind::Unplug) {
      throw Error(ErrorCode::RunFailed, phrase("camera: unplugged"));
    }
  }

  std::optional<TimedImage> next(const std::stop_token& stop) override {
    waitFor(std::max(0.0, due_s_ - clock_()), stop);
    if (stop.stop_requested()) return std::nullopt;
    due_s_ = std::max(due_s_ + 1.0 / camera_.rate_hz, clock_());
    const CameraPlace::At at = place_->now();
    const auto wrong = fault();
    if (wrong == FaultKind::Unplug) throw Error(ErrorCode::RunFailed, phrase("camera: unplugged"));
    if (wrong == FaultKind::Drop && ++dropped_ % 2 == 0) return next(stop);
    if (wrong != FaultKind::Freeze || frozen_.empty()) frozen_ = picture(at, wrong);
    const double late_s = wrong == FaultKind::Late ? kLate_s : 0.0;
    return TimedImage{at.time_s - late_s, frozen_};
  }

 private:
  std::optional<FaultKind> fault() const {
    return faultAt(camera_.faults, DeviceRole::Camera, clock_());
  }

  /// What was rendered for this place already, with some noise of its own: rendering takes a tenth
  /// of a second and more, and a head that looks around stands most of the time.
  StereoImages seen(const CameraPlace::At& at) {
    const bool same = rendered_at_ && rendered_at_->robot == at.robot &&
                      rendered_at_->pan == at.pan && at.time_s < rendered_at_->time_s + kKept_s;
    if (!same) {
      const Scene scene = renderer_.sceneAt(camera_.world, at.robot, at.time_s);
      rendered_ = renderer_.images(scene, at.robot, at.pan, ++pictures_, 0);
      rendered_at_ = at;
      return rendered_;
    }
    StereoImages images;
    for (const auto& [from, to] :
         {std::pair(&rendered_.left, &images.left), std::pair(&rendered_.right, &images.right)}) {
      cv::Mat noise(from->size(), CV_MAKETYPE(CV_16S, from->channels()));
      noise_.fill(noise, cv::RNG::NORMAL, 0.0, kNoise);
      cv::add(*from, noise, *to, cv::noArray(), CV_8U);
    }
    return images;
  }

  cv::Mat picture(const CameraPlace::At& at, std::optional<FaultKind> wrong) {
    StereoImages images = seen(at);
    if (wrong == FaultKind::Swap) std::swap(images.left, images.right);
    cv::Mat both;
    cv::hconcat(images.left, images.right, both);
    if (wrong == FaultKind::Half) {
      both.rowRange(static_cast<int>(kHalf * both.rows), both.rows).setTo(cv::Scalar::all(128));
    }
    return both;
  }

  RenderedCamera camera_;
  std::shared_ptr<CameraPlace> place_;
  RigClock clock_;
  Renderer renderer_;
  double due_s_;
  std::uint32_t pictures_ = 0;  ///< rendered: each has noise of its own
  StereoImages rendered_;
  std::optional<CameraPlace::At> rendered_at_;
  cv::RNG noise_;
  int dropped_ = 0;
  cv::Mat frozen_;
};

}  // namespace

void CameraPlace::tell(const At& at) {
  const std::scoped_lock lock(mutex_);
  at_ = at;
}

CameraPlace::At CameraPlace::now() const {
  const std::scoped_lock lock(mutex_);
  return at_;
}

OpenImageDevice renderedDevice(RenderedCamera camera, std::shared_ptr<CameraPlace> place,
                               RigClock clock) {
  return [camera = std::move(camera), place = std::move(place), clock = std::move(clock)] {
    return std::make_unique<RenderedDevice>(camera, place, clock);
  };
}

}  // namespace handmap
