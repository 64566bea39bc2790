#include "core/odometry/visual_odometry_source.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/stopwatch.h"
#include "core/odometry/constants.h"
#include "core/odometry/stereo_odometry.h"

namespace handmap {

using namespace odometry;

namespace {

const View& viewAhead(const Observation& observation) {
  return *std::min_element(
      observation.views.begin(), observation.views.end(), [](const View& a, const View& b) {
        return std::abs(normalizedAngle(a.pan)) < std::abs(normalizedAngle(b.pan));
      });
}

class VisualOdometrySource : public ObservationSource {
 public:
  VisualOdometrySource(std::unique_ptr<ObservationSource> source, const StereoCamera& camera,
                       WhenLost when_lost)
      : source_(std::move(source)),
        info_(source_->info()),
        odometry_(camera),
        when_lost_(when_lost) {
    info_.start_odometry = {};
    info_.odometry.clear();
    info_.visual_odometry = true;
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    std::optional<Observation> observation = source_->next();
    if (!observation) return observation;
    const Stopwatch watch;
    move(*observation);
    observation->read_ms += watch.ms();
    return observation;
  }

 private:
  void move(Observation& observation) {
    const auto motion = motionTo(observation);
    observation.odometry_guessed = motion && motion->guessed;
    const bool believed = !observation.odometry_guessed ||
                          (!observation.standing && observation.time_s - seen_s_ <= kBelieved_s);
    if (motion && believed) pose_ = pose_ * motion->motion;
    observation.odometry = pose_;
    if (!observation.odometry_guessed) {
      seen_s_ = observation.time_s;
      seen_frame_ = observation.frame;
    }
    if (believed || when_lost_ == WhenLost::StandStill) return;
    throw Error(
        ErrorCode::RunFailed,
        phrase("frame {}: found {} points in common with frame {}, {} of them moving "
               "as one: too few to tell how the robot moved in between",
               observation.frame, motion->matches, seen_frame_, motion->inliers),
        phrase("take more frames (a smaller --every), or give an odometry: --odometry FILE.tum"));
  }

  std::optional<VisualMotion> motionTo(const Observation& observation) {
    if (observation.views.empty()) throw FrameError(observation.frame, phrase("no view"));
    const View& view = viewAhead(observation);
    try {
      return odometry_(view.left, view.right, observation.time_s, view.pan);
    } catch (const Error& error) {
      throw FrameError(observation.frame, error.what());
    }
  }

  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  StereoOdometry odometry_;
  WhenLost when_lost_;
  Pose2 pose_;
  double seen_s_ = 0.0;  ///< when the motion was last told by the images
  int seen_frame_ = 0;
};

}  // namespace

std::unique_ptr<ObservationSource> withVisualOdometry(std::unique_ptr<ObservationSource> source,
                                                      WhenLost when_lost) {
  const std::optional<StereoCamera> camera = source->info().camera;
  if (!camera) {
    throwBadInput(source->info().name, "", phrase("no stereo camera"),
                  phrase("images for visual odometry"));
  }
  return std::make_unique<VisualOdometrySource>(std::move(source), *camera, when_lost);
}

std::unique_ptr<ObservationSource> replayWithOdometry(Recording recording, ReplayOptions options) {
  const auto& rows = recording.rows;
  const bool sees_images =
      options.kind != SourceKind::Points &&
      std::any_of(rows.begin(), rows.end(), [](const FrameRow& row) { return !row.left.empty(); });
  if (sees_images && recording.odometry.empty() && options.odometry.empty()) {
    options.visual_odometry = true;
  }
  auto source = replay(std::move(recording), options);
  return options.visual_odometry ? withVisualOdometry(std::move(source)) : std::move(source);
}

}  // namespace handmap
