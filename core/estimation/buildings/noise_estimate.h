// The range noise, estimated from how far returns lie from the walls that they are from.
#pragma once

#include <array>
#include <span>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/buildings/found_box.h"

namespace handmap {

/// σ by distance, collected over frames; a little is forgotten with each.
class NoiseEstimate {
 public:
  /// Returns of the frame from walls of the boxes that are met at steep angles.
  void add(const Frame& frame, std::span<const FoundBox> boxes, const SensorModel& sensor);
  /// The noise that fits; `assumed` where there is too little to tell.
  RangeNoise fitted(const RangeNoise& assumed) const;
  /// How far, across a wall, the returns of one frame are off together, one σ.
  double systematic() const;

 private:
  struct Bin {
    double weight = 0.0;
    double squares = 0.0;
  };
  std::array<Bin, buildings::kBins> bins_{};
  Bin together_;  ///< squares of the mean errors of frames, less what range noise explains
};

/// Whether evidence weighed with one is no longer worth anything with the other.
bool differMuch(const RangeNoise& a, const RangeNoise& b);

}  // namespace handmap
