// What a run has made of a drawing that nobody should take over unseen: corrected buildings that
// stand in each other, and such as were probably fitted to something else.
#pragma once

#include <span>
#include <vector>

#include "core/map/map.h"

namespace handmap {

struct Concern {
  enum class Kind { Overlaps, Moved, Resized };
  Kind kind;
  std::size_t building;   ///< of the drawing
  std::size_t other = 0;  ///< Overlaps: the building that it shares ground with
  /// Overlaps: how much more of the smaller one's area is shared than in the drawing, 0 … 1; Moved
  /// and Resized: metres.
  double by = 0.0;
};

/// `refined`: of a run on `drawing`, its buildings in the same order; those that nobody saw stand
/// where the drawing has them and are no concern, but where others stand in them. By building.
std::vector<Concern> concernsOf(const Map& drawing, const Map& refined);

/// Probability that a building was fitted to something else, a hedge, a car or its neighbour, by
/// how far off that is from where and how large it is drawn, in σ of the drawing. 0 of one not
/// seen.
double misfitProbability(const Map& drawing, const Building& drawn, const Building& refined);

/// Of those of concernsOf() the ones about one building.
std::span<const Concern> concernsAbout(std::size_t building, std::span<const Concern> concerns);

}  // namespace handmap
