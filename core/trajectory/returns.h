// What of an observation's returns tells the way.
#pragma once

#include <vector>

#include "core/trajectory/scan_features.h"
#include "core/trajectory/sharpness.h"
#include "core/trajectory/track_map.h"

namespace handmap {

/// The returns of one observation in the plane, metres, robot frame.
struct Returns {
  bool planar = true;
  std::vector<RangePoint> all;  ///< that can be used: in range, finite, not said to be nothing
  std::vector<Vec2> upright;    ///< of a planar scan all, else those above cars and hedges
};

Returns usableReturns(const std::vector<RangePoint>& points, double range_limit_m);

/// Looks at followed points; `ids` as View has them.
std::vector<TrackedPoint> trackedPoints(const std::vector<RangePoint>& points,
                                        const std::vector<std::uint32_t>& ids);

std::vector<ScanPoint> features(const Returns& returns, const ScanNoise& noise = {});

/// At most 100 of them, evenly taken, with the noise known now.
SharpnessFrame sharpnessFrame(const Returns& returns, double range_limit_m, const ScanNoise& noise);

}  // namespace handmap
