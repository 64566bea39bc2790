// Where the time of an observation goes, against the time between two of them.
#pragma once

#include <array>
#include <deque>
#include <optional>

#include "widgets/run/panels/stages.h"

namespace handmap {

class FrameBudget {
 public:
  /// Of the latest so many observations.
  static constexpr std::size_t kMostFrames = 1000;

  void add(const FrameReport& report);
  void clear();

  struct Line {
    double share = 0.0;  ///< of all time, 0 … 1
    double p50_ms = 0.0;
    double p95_ms = 0.0;
  };
  Line of(double StageTimes::*stage) const;
  Line total() const;
  /// Median time between two observations, of the recording's clock; nullopt before there are two.
  std::optional<double> intervalMs() const;
  bool empty() const { return frames_.empty(); }

 private:
  struct Frame {
    double time_s;
    StageTimes ms;
  };
  std::deque<Frame> frames_;
};

}  // namespace handmap
