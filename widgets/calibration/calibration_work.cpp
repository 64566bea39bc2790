#include "widgets/calibration/calibration_work.h"

#include "core/base/error.h"

namespace handmap {

/// Outlives the window as long as a thread works with it.
struct CalibrationWork::Shared {
  Shared(const Board& board, const std::filesystem::path& keep) : capture(board, keep) {}

  std::mutex working;  ///< a second look waits for the first one to end
  BoardCapture capture;
  std::mutex mutex;
  std::shared_ptr<const CaptureStatus> newest;  ///< under mutex
};

namespace {

Rig rigOf(const CameraRig& camera) {
  Rig rig;
  rig.name = "cameras";
  rig.camera = camera;
  return rig;
}

std::string nameOf(const CameraRig& camera) {
  return camera.right.empty() ? camera.left : camera.left + " and " + camera.right;
}

}  // namespace

CalibrationWork::CalibrationWork(QObject* parent)
    : QObject(parent), self_(std::make_shared<Lifeline<CalibrationWork>>(*this)) {}

CalibrationWork::~CalibrationWork() {
  self_->cut();
  stop();
}

void CalibrationWork::begin(const Board& board, const std::filesystem::path& keep) {
  stop();
  shared_ = std::make_shared<Shared>(board, keep);
}

void CalibrationWork::look(const CameraRig& camera, const RigAccess& access) {
  stop();
  stop_ = {};
  monitor_ = std::make_shared<RigMonitor>();
  startInBackground([self = self_, shared = shared_, camera, host = access.host, monitor = monitor_,
                     stop = stop_.get_token()] {
    const auto tell = [&self](const Failure& failure) {
      self->post([failure](CalibrationWork& work) { Q_EMIT work.failed(failure); });
    };
    try {
      const std::scoped_lock working(shared->working);
      host(rigOf(camera), monitor, stop, [&shared](const Observation& observation) {
        const View& view = observation.views.front();
        auto status = std::make_shared<const CaptureStatus>(
            shared->capture.look(observation.time_s, view.left, view.right));
        const std::scoped_lock lock(shared->mutex);
        shared->newest = std::move(status);
      });
      if (stop.stop_requested()) return;
      auto captured =
          std::make_shared<const CapturedCalibration>(shared->capture.calibrate(nameOf(camera)));
      self->post([captured](CalibrationWork& work) { Q_EMIT work.calibrated(captured); });
    } catch (const Error& error) {
      tell(failureOf(error));
    } catch (const std::exception& error) {
      tell({ErrorCode::RunFailed, QString::fromUtf8(error.what()), {}});
    }
  });
}

void CalibrationWork::finish() {
  if (monitor_) monitor_->end();
}

void CalibrationWork::stop() {
  stop_.request_stop();
  finish();
}

std::shared_ptr<const CaptureStatus> CalibrationWork::newest() const {
  if (!shared_) return nullptr;
  const std::scoped_lock lock(shared_->mutex);
  return shared_->newest;
}

}  // namespace handmap
