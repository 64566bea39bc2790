#pragma once

#include <vector>

#include "core/recording/observation.h"

namespace handmap {

/// Observations with the given times.
class ListSource : public ObservationSource {
 public:
  explicit ListSource(std::vector<double> times) : times_(std::move(times)) {
    info_.observations = static_cast<int>(times_.size());
  }
  const SourceInfo& info() const override { return info_; }
  std::optional<Observation> next() override {
    if (next_ == times_.size()) return std::nullopt;
    Observation observation;
    observation.frame = static_cast<int>(next_);
    observation.time_s = times_[next_++];
    return observation;
  }

 private:
  SourceInfo info_;
  std::vector<double> times_;
  std::size_t next_ = 0;
};

}  // namespace handmap
