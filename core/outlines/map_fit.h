// The buildings of a drawing fitted to what a whole run saw, on a way that is given.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/map/certainty.h"
#include "core/outlines/outline_task.h"

namespace handmap {

enum class Verdict { Moved, Kept };

struct OutlineResult {
  Polygon outline;  ///< the fitted one, or the drawn one where that was kept
  Verdict verdict = Verdict::Kept;
  double evidence = 0.0;             ///< log ratio of the fitted one against nothing there
  double gain = 0.0;                 ///< the same against the drawn one
  std::optional<Estimate> estimate;  ///< of the outline, where the rays speak for it
  Sides sides;                       ///< the same
  /// That it is another house of its row; 1 where it was looked through and found nowhere else.
  double doubt = 0.0;
};

/// One result a task. A building is moved where the rays speak for a building there and against the
/// drawn place; two buildings do not take the same returns. Empty where `stop` was requested.
std::vector<OutlineResult> fitOutlines(const std::vector<OutlineTask>& tasks,
                                       const PlacedRays& placed, double range_limit_m,
                                       std::uint64_t seed, const std::stop_token& stop = {},
                                       const std::function<void(double)>& progress = {});

}  // namespace handmap
