// Whether a recording can be what it says: its numbers looked at before a run believes them.
//
// A look at some forty frames and at the whole odometry, a tenth of a second. What robots on the
// ground do and what their sensors reach decides; where two readings are likely, the one in which
// scans agree with each other along the odometry.
#pragma once

#include <stop_token>

#include "core/plausibility/doubt.h"

namespace handmap {

/// Codes: odometry_units, odometry_heading, odometry_gaps, time_units, two_clocks, points_units,
/// points_axes, ray_directions, opposite_turns, heights, range_limit, points_missing,
/// scans_repeated, likelihood_zero, strange_key. Throws Error when `stop` is requested.
Doubts doubtsOf(const Recording& recording, const std::stop_token& stop = {});

}  // namespace handmap
