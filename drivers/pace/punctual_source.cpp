#include "drivers/pace/punctual_source.h"

#include <algorithm>

#include "core/base/phrase.h"

namespace handmap {

namespace {

constexpr double kLeastBudget = 0.02;  // seconds: what a scheduler may be late

}  // namespace

PunctualSource::PunctualSource(std::unique_ptr<ObservationSource> source, double speed,
                               std::stop_token stop)
    : source_(std::move(source)), info_(source_->info()), pace_(speed), stop_(std::move(stop)) {
  info_.speed = speed;
}

std::optional<Observation> PunctualSource::next() {
  std::optional<Observation> observation = source_->next();
  if (!observation) return observation;
  if (!start_) {
    start_ = Start{observation->time_s, Pace::Clock::now()};
    before_s_ = observation->time_s;
    return observation;
  }
  const double due = (observation->time_s - start_->time_s) / info_.speed;
  const double budget = std::max((observation->time_s - before_s_) / info_.speed, kLeastBudget);
  before_s_ = observation->time_s;
  pace_.waitFor(observation->time_s - start_->time_s, start_->at, stop_);
  const double late = std::chrono::duration<double>(Pace::Clock::now() - start_->at).count() - due;
  if (late <= budget) return observation;
  throw FrameError(observation->frame,
                   phrase("passed over: {:.2f} s late, the budget is {:.2f} s", late, budget));
}

}  // namespace handmap
