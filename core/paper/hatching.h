// Hatched buildings: strokes side by side that fill an outline and are no walls.
#pragma once

#include "core/paper/ink.h"

namespace handmap {

/// The ink without the strokes of hatching, single or crossed, that reach from wall to wall. What
/// does not reach is no border of anything and stays.
cv::Mat withoutHatching(const Ink& ink);

}  // namespace handmap
