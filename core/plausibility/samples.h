// Some frames with points, all along a recording.
#pragma once

#include <stop_token>
#include <vector>

#include "core/recording/recording.h"

namespace handmap {

struct PointsSample {
  std::size_t row = 0;
  std::vector<RangePoint> points;
};

/// Rows that name points, in their order.
std::vector<std::size_t> rowsWithPoints(const Recording& recording);
/// Those that can be read, of at most so many evenly chosen ones.
std::vector<PointsSample> samplesOf(const Recording& recording, std::size_t most,
                                    const std::stop_token& stop);

}  // namespace handmap
