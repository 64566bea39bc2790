// What time stamps of files may be.
#pragma once

#include <cmath>
#include <string>

#include "core/base/phrase.h"

namespace handmap {

inline constexpr double kMaxTime_s = 1e12;  ///< of any epoch, either sign

/// What a time is likely to be counted in that is no number of seconds; empty where it may be one.
/// Since 1970 it is 1.7e9 s.
inline std::string likelyUnitOfTime(double time) {
  constexpr double kMost_s = 1e10;  // the year 2286
  const double size = std::abs(time);
  if (size > 1e6 * kMost_s) return phrase("nanoseconds");
  if (size > 1e3 * kMost_s) return phrase("microseconds");
  return size > kMost_s ? phrase("milliseconds") : std::string();
}

}  // namespace handmap
