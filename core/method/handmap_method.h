// Our method: the way of the sensors, the buildings found along it, the drawing fitted to what was
// seen.
#pragma once

#include "core/method/estimation_method.h"

namespace handmap {

std::unique_ptr<EstimationMethod> makeHandmapMethod(const Map& drawing, const SourceInfo& source,
                                                    const RunSettings& settings);

}  // namespace handmap
