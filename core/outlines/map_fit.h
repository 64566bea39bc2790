// The buildings of a drawing fitted to what a whole run saw, on a way that is given.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/map/certainty.h"
#include "core/outlines/outline_search.h"

namespace handmap {

/// A building to be fitted.
struct OutlineTask {
  Polygon drawn;               ///< as drawn, carried along with the whole drawing
  Polygon start;               ///< where it is looked for first
  double shift_m = 0.0;        ///< how far that may be off, one σ
  double drawn_shift_m = 0.0;  ///< how far the drawn place may be off, one σ
  double size_m = 0.0;         ///< how far its sizes may, one σ
  WholeUncertainty whole;      ///< of a drawing that it was not carried along with, where stated
  bool rectangle = false;      ///< stays one
  bool labelled = false;       ///< something was found at the start that is taken for it
};

enum class Verdict { Moved, Kept };

struct OutlineResult {
  Polygon outline;  ///< the fitted one, or the drawn one where that was kept
  Verdict verdict = Verdict::Kept;
  double evidence = 0.0;             ///< log ratio of the fitted one against nothing there
  double gain = 0.0;                 ///< the same against the drawn one
  std::optional<Estimate> estimate;  ///< of the outline, where the rays speak for it
  Sides sides;                       ///< the same
};

/// One result a task. A building is moved where the rays speak for a building there and against the
/// drawn place; two buildings do not take the same returns. Empty where `stop` was requested.
std::vector<OutlineResult> fitOutlines(const std::vector<OutlineTask>& tasks,
                                       const PlacedRays& placed, double range_limit_m,
                                       std::uint64_t seed, const std::stop_token& stop = {},
                                       const std::function<void(double)>& progress = {});

}  // namespace handmap
