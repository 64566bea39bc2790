#include "drivers/pace/paced_source.h"

namespace handmap {

PacedSource::PacedSource(std::unique_ptr<ObservationSource> source, std::shared_ptr<Pace> pace,
                         std::stop_token stop)
    : source_(std::move(source)), pace_(std::move(pace)), stop_(std::move(stop)) {}

std::optional<Observation> PacedSource::next() {
  std::optional<Observation> observation = source_->next();
  if (!observation) return observation;
  // Counted from the last release, not from the start: a slow step or a pause is not made up for by
  // a burst.
  if (last_) pace_->waitFor(observation->time_s - last_->time_s, last_->at, stop_);
  last_ = Release{observation->time_s, Pace::Clock::now()};
  return observation;
}

}  // namespace handmap
