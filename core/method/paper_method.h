#pragma once

#include "core/method/estimation_method.h"

namespace handmap {

/// FastSLAM/PSOM as published.
std::unique_ptr<EstimationMethod> makePaperMethod(const Map& drawing, const SourceInfo& source,
                                                  const RunSettings& settings);

}  // namespace handmap
