#include "drivers/live/live_source.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/odometry/visual_odometry_source.h"
#include "core/recording/calibration.h"
#include "core/recording/image_check.h"
#include "core/recording/rectifier.h"
#include "core/recording/stereo_calibration.h"
#include "core/trajectory/scan_odometry_source.h"
#include "drivers/live/recording_source.h"
#include "drivers/live/rig_host.h"

namespace handmap {

namespace {

/// So often it is looked whether left is left: a camera that was pulled may come back as the other.
constexpr double kLookClosely_s = 1.0;

/// The camera behind the images that the run gets, and how they are made.
struct Optics {
  StereoCamera camera;
  std::shared_ptr<const Rectifier> rectifier;  ///< none: they come rectified
};

/// nullopt: the rig does not say.
std::optional<Optics> opticsOf(const CameraRig& rig) {
  if (rig.optics) return Optics{*rig.optics, {}};
  if (rig.calibration.empty()) return std::nullopt;
  const std::string ending = rig.calibration.extension().string();
  if (ending == ".txt") return Optics{readCalibration(rig.calibration, "P0", "P1", rig.mount), {}};
  const auto rectifier = std::make_shared<const Rectifier>(readStereoCalibration(rig.calibration),
                                                           rig.calibration.string());
  return Optics{rectifier->camera(rig.mount), rectifier};
}

class LiveSource : public ObservationSource {
 public:
  LiveSource(const LiveJob& job, std::stop_token stop)
      : monitor_(job.monitor), stop_(std::move(stop)) {
    info_.name = job.rig.name;
    info_.range_limit_m = job.rig.range_limit_m;
    info_.speed = 1.0;
    info_.without_odometry = job.rig.odometry.kind == OdometryRigKind::Scan;
    if (job.rig.camera) {
      mount_ = job.rig.camera->mount;
      optics_ = opticsOf(*job.rig.camera);
      if (optics_) info_.camera = optics_->camera;
    }
    host_ = std::make_unique<RigHost>(job.rig, job.make, monitor_);
  }

  /// False: there will be none.
  bool waitForFirst() {
    while (!first_) {
      try {
        first_ = take();
        if (!first_) return false;
      } catch (const FrameError&) {
        // told by the monitor
      }
    }
    info_.start_odometry = first_->odometry;
    // Silence says nothing of what is beyond the scanner's reach.
    info_.range_limit_m = std::min(info_.range_limit_m, std::max(host_->reach_m(), kLeastReach_m));
    return true;
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    if (first_) return std::exchange(first_, std::nullopt);
    return take();
  }

 private:
  std::optional<Observation> take() {
    std::optional<Observation> observation = host_->next(stop_);
    if (!observation) return observation;
    const auto begin = std::chrono::steady_clock::now();
    try {
      const bool closely = observation->time_s >= look_closely_s_;
      if (closely) look_closely_s_ = observation->time_s + kLookClosely_s;
      for (View& view : observation->views) prepare(view, observation->frame, closely);
    } catch (const Error& error) {
      monitor_->refused(phrase("image that nothing can be seen with"), error.what());
      throw FrameError(observation->frame, error.what());
    }
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - begin;
    observation->read_ms = spent.count();
    monitor_->given();
    return observation;
  }

  void prepare(View& view, int frame, bool closely) {
    if (view.left.empty()) return;
    const std::string name = phrase("live frame {}", frame);
    if (!optics_) askOptics(name);
    if (optics_->rectifier && view.left.size() != optics_->rectifier->size()) {
      const cv::Size expected = optics_->rectifier->size();
      throwBadInput(name, "", phrase("{} × {} pixels", view.left.cols, view.left.rows),
                    phrase("{} × {} as the calibration says", expected.width, expected.height));
    }
    checkPicture(view.left, phrase("{}, left", name));
    checkPicture(view.right, phrase("{}, right", name));
    if (optics_->rectifier) {
      view.left = optics_->rectifier->left(view.left);
      view.right = optics_->rectifier->right(view.right);
    }
    if (closely) SwapCheck()(view.left, view.right, name);
  }

  /// The robot tells what the rig does not say. Before the first observation is given.
  void askOptics(const std::string& name) {
    const auto rectifier = host_->rectifier();
    if (!rectifier) {
      throwBadInput(name, "", phrase("no calibration"), phrase("that of the rig or of the robot"));
    }
    optics_ = Optics{rectifier->camera(mount_), rectifier};
    info_.camera = optics_->camera;
  }

  std::shared_ptr<RigMonitor> monitor_;
  std::stop_token stop_;
  SourceInfo info_;
  CameraMount mount_;
  std::optional<Optics> optics_;
  double look_closely_s_ = -std::numeric_limits<double>::infinity();
  std::unique_ptr<RigHost> host_;
  std::optional<Observation> first_;
};

std::unique_ptr<ObservationSource> recordedFor(const LiveJob& job,
                                               std::unique_ptr<ObservationSource> source) {
  if (job.record.empty()) return source;
  return recorded(
      std::move(source), job.record,
      [monitor = job.monitor](const RecordingStatus& status) { monitor->setRecording(status); });
}

}  // namespace

std::unique_ptr<ObservationSource> openLive(const LiveJob& job, const std::stop_token& stop) {
  auto live = std::make_unique<LiveSource>(job, stop);
  if (!live->waitForFirst()) return nullptr;
  // What the scans say of the motion is as unsure in a replay, which makes it anew.
  if (job.rig.odometry.kind == OdometryRigKind::Scan)
    return withScansAlone(recordedFor(job, std::move(live)));
  if (job.rig.odometry.kind != OdometryRigKind::Visual) return recordedFor(job, std::move(live));
  return recordedFor(job, withVisualOdometry(std::move(live), WhenLost::StandStill));
}

}  // namespace handmap
