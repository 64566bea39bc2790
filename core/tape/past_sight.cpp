#include "core/tape/past_sight.h"

#include "core/tape/tape.h"

namespace handmap {

std::shared_ptr<const Perceived> PastSight::lock() const {
  if (auto held = held_.lock()) return held;
  const auto tape = tape_.lock();
  return tape ? tape->at(n_) : nullptr;
}

LazyLocalMap PastSight::localMap() const {
  const auto tape = tape_.lock();
  if (!tape) return {};
  const double range_m = tape->info().range_limit_m;
  const LocalMapOptions& options = tape->localMapOptions();
  return LazyLocalMap(range_m, [tape = tape_, n = n_, options, range_m] {
    const auto kept = tape.lock();
    return kept ? kept->localMap(n) : LocalMap(options.cell_m, range_m);
  });
}

}  // namespace handmap
