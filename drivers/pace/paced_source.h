// A source that releases its observations no faster than their own clock times a speed.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/recording/observation.h"
#include "drivers/pace/pace.h"

namespace handmap {

class PacedSource : public ObservationSource {
 public:
  /// A requested `stop` ends every wait at once; the observation is then given out early.
  PacedSource(std::unique_ptr<ObservationSource> source, std::shared_ptr<Pace> pace,
              std::stop_token stop);

  const SourceInfo& info() const override { return source_->info(); }
  std::optional<Observation> next() override;

 private:
  struct Release {
    double time_s;
    Pace::Clock::time_point at;
  };
  std::unique_ptr<ObservationSource> source_;
  std::shared_ptr<Pace> pace_;
  std::stop_token stop_;
  std::optional<Release> last_;
};

}  // namespace handmap
