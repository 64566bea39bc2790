// When a device that was lost is tried again: soon at first, then ever more rarely, never at the
// same moment as the others.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

#include "core/base/random.h"

namespace handmap {

/// 0.5 s, 1 s, 2 s, 4 s, 8 s, 8 s … between two attempts, each up to a fifth shorter by chance:
/// what hangs on one hub and was lost together does not come back in one burst.
class Reconnect {
 public:
  /// The same seed gives the same delays.
  explicit Reconnect(std::uint64_t seed) : random_(seed) {}

  /// From now to the next attempt.
  std::chrono::milliseconds nextDelay() {
    const double whole_ms = std::min(kShortest_ms * std::exp2(failures_), kLongest_ms);
    failures_ = std::min(failures_ + 1, kMostDoublings);
    const double delay_ms = whole_ms * random_.uniform(1.0 - kJitter, 1.0);
    return std::chrono::milliseconds(std::llround(std::max(delay_ms, kShortest_ms)));
  }

  /// It delivers again: only now, not when it could be opened, the waiting begins from the start.
  void succeeded() { failures_ = 0; }

 private:
  static constexpr double kShortest_ms = 500.0;
  static constexpr double kLongest_ms = 8000.0;
  static constexpr double kJitter = 0.2;
  static constexpr int kMostDoublings = 4;  // 0.5 s · 2⁴ = 8 s

  RandomStream random_;
  int failures_ = 0;
};

}  // namespace handmap
