// A source that keeps to its own clock, as a live robot does: what the run has no time for is
// passed over.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/recording/observation.h"
#include "drivers/pace/pace.h"

namespace handmap {

class PunctualSource : public ObservationSource {
 public:
  /// `speed` > 0: 1 is that of the recording. A requested `stop` ends every wait at once.
  PunctualSource(std::unique_ptr<ObservationSource> source, double speed, std::stop_token stop);

  const SourceInfo& info() const override { return info_; }
  /// Waits for an observation that is not due yet. The budget of one is the time between it and the
  /// one before: if it is later than that, the run is a whole observation behind. It is then passed
  /// over with a FrameError; its odometry is not lost, that of the next one includes it.
  std::optional<Observation> next() override;

 private:
  struct Start {
    double time_s;
    Pace::Clock::time_point at;
  };
  std::unique_ptr<ObservationSource> source_;
  SourceInfo info_;
  Pace pace_;
  std::stop_token stop_;
  std::optional<Start> start_;
  double before_s_ = 0.0;  ///< time of the observation before
};

}  // namespace handmap
