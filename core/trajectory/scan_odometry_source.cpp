#include "core/trajectory/scan_odometry_source.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/base/stopwatch.h"
#include "core/odometry/odometry_noise.h"
#include "core/perception/joined_frames.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/local_map_odometry.h"
#include "core/trajectory/returns.h"

namespace handmap {

using namespace trajectory;

namespace {

class ScanOdometrySource : public ObservationSource {
 public:
  ScanOdometrySource(std::unique_ptr<ObservationSource> source, bool alone)
      : source_(std::move(source)), info_(source_->info()), alone_(alone) {
    if (alone) odometry_ = LocalMapOdometry::ofGuesses();
    info_.odometry.clear();
    info_.without_odometry = false;
  }

  const SourceInfo& info() const override { return info_; }

  std::optional<Observation> next() override {
    std::optional<Observation> observation = source_->next();
    if (!observation) return observation;
    const Stopwatch watch;
    SeenPoints seen = allPoints(*observation);
    const Pose2 before = odometry_.pose();
    const double elapsed_s = observation->time_s - time_s_;
    if (alone_) guessed_ = guessed_ * motionIn(elapsed_s);
    const Pose2& recorded = alone_ ? guessed_ : observation->odometry;
    if (!seen.ids.empty()) joined_.removeRepeats(seen, recorded);
    const Returns returns = usableReturns(seen.points, info_.range_limit_m);
    if (!alone_) noise_.add(returns.upright);  // guesses are held by details that noise may hide
    const bool matched =
        odometry_.add(recorded, features(returns, noise_), trackedPoints(seen.points, seen.ids));
    // Where it was silent the robot may be anywhere near, until the next scan is recognised.
    is_blind_ = !seesAnything(*observation) || (is_blind_ && (!matched || odometry_.unheld()));
    if (!is_blind_ || !any_) seen_s_ = observation->time_s;
    observation->blind_s = is_blind_ ? observation->time_s - seen_s_ : 0.0;
    if (alone_ && any_ && !is_blind_) guess(elapsed_s, matched);
    observation->odometry_guessed = is_blind_ || guess_.off_m() > kWorthAWord_m;
    observation->odometry = odometry_.pose();
    observation->odometry_variance = guess_.variance();
    motion_ = between(before, odometry_.pose());
    motion_s_ = any_ ? elapsed_s : 0.0;
    time_s_ = observation->time_s;
    any_ = true;
    observation->read_ms += watch.ms();
    return observation;
  }

 private:
  void guess(double elapsed_s, bool matched) {
    if (!matched) {
      guess_.goOn(elapsed_s, Guess::Of::All);
    } else if (const auto& along = odometry_.unheld()) {
      guess_.goOn(elapsed_s, Guess::Of::Along, *along);
    } else {
      guess_.hold();
    }
  }
  /// At the speed of before.
  Pose2 motionIn(double elapsed_s) const {
    if (motion_s_ <= 0.0) return {};
    const double share = std::min(kMostOfBefore, elapsed_s / motion_s_);
    return {share * motion_.x, share * motion_.y, share * motion_.heading};
  }

  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  LocalMapOdometry odometry_;
  ScanNoise noise_;
  JoinedFrames joined_;
  bool alone_;
  bool any_ = false;
  Guess guess_;
  Pose2 guessed_;  ///< all motions as they were guessed
  Pose2 motion_;
  double motion_s_ = 0.0;  ///< that it took
  double time_s_ = 0.0;
  bool is_blind_ = false;
  double seen_s_ = 0.0;  ///< the newest that was recognised
};

}  // namespace

SeenPoints allPoints(const Observation& observation) {
  SeenPoints seen;
  for (const View& view : observation.views) {
    if (!view.points) {
      throwBadInput(phrase("frame {}", observation.frame), "", phrase("images"),
                    phrase("range points for odometry from scans"));
    }
    seen.add(view);
  }
  return seen;
}

std::unique_ptr<ObservationSource> withScanOdometry(std::unique_ptr<ObservationSource> source) {
  return std::make_unique<ScanOdometrySource>(std::move(source), false);
}

std::unique_ptr<ObservationSource> withScansAlone(std::unique_ptr<ObservationSource> source) {
  return std::make_unique<ScanOdometrySource>(std::move(source), true);
}

}  // namespace handmap
