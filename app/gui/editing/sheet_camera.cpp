#include "app/gui/editing/sheet_camera.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include "drivers/camera/frame_grabber.h"
#include "drivers/camera/image_devices.h"

namespace handmap {

namespace {

constexpr std::chrono::milliseconds kBetween(250);  // a hand draws no building in less

}  // namespace

/// The image that waits to be looked at.
struct SheetCamera::Newest {
  std::mutex mutex;
  std::condition_variable_any come;
  std::optional<cv::Mat> image;  ///< under mutex

  void put(cv::Mat next) {
    const std::scoped_lock lock(mutex);
    image = std::move(next);
    come.notify_one();
  }
  /// nullopt: stopped.
  std::optional<cv::Mat> take(const std::stop_token& stop) {
    std::unique_lock lock(mutex);
    come.wait(lock, stop, [this] { return image.has_value(); });
    return stop.stop_requested() ? std::nullopt : std::exchange(image, std::nullopt);
  }
};

SheetCamera::SheetCamera(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<SheetCamera>>(*this)) {}

SheetCamera::~SheetCamera() {
  self_->cut();
  stop_.request_stop();
}

void SheetCamera::stop() {
  stop_.request_stop();
  ++request_;
}

void SheetCamera::watch(const QString& source) {
  stop();
  stop_ = {};
  startInBackground(
      [self = self_, request = request_, stop = stop_.get_token(), source = source.toStdString()] {
        const auto post = [&self, request](auto say) {
          self->post([request, say](SheetCamera& camera) {
            if (request == camera.request_) say(camera);
          });
        };
        Newest newest;
        const RigClock clock = startedRigClock();
        const FrameGrabber grabber(
            source, imageDevice(CameraRig{}, source, clock, clock()), 1,
            [&newest](TimedImage frame) { newest.put(std::move(frame.image)); },
            [&post](FrameGrabber::State state, const std::string& detail) {
              if (state != FrameGrabber::State::Lost && state != FrameGrabber::State::AtEnd) return;
              post([detail](SheetCamera& camera) {
                Q_EMIT camera.troubled(QString::fromStdString(detail));
              });
            });
        SheetWatch watch;
        std::optional<SheetSight> before;
        while (const auto image = newest.take(stop)) {
          const auto begun = std::chrono::steady_clock::now();
          const SheetSight sight = watch.look(*image);
          if (sight != before)
            post([sight](SheetCamera& camera) { Q_EMIT camera.sightChanged(sight); });
          before = sight;
          if (watch.isNew()) {
            auto reading = std::make_shared<PaperReading>();
            reading->trace = watch.trace();
            reading->numbers = watch.numbers();
            reading->page = pngOf(imageOf(reading->trace.page.image));
            post([reading](SheetCamera& camera) { Q_EMIT camera.seen(reading); });
          }
          const std::chrono::duration<double> left =
              kBetween - (std::chrono::steady_clock::now() - begun);
          waitFor(left.count(), stop);
        }
      });
}

}  // namespace handmap
