// Where the robot is on a map that is right: nothing of the map is corrected.
#pragma once

#include "core/method/estimation_method.h"

namespace handmap {

std::unique_ptr<EstimationMethod> makeLocalizationMethod(const Map& map, const SourceInfo& source,
                                                         const RunSettings& settings);

}  // namespace handmap
