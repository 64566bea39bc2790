// Arrays of numpy to scans and poses.
#pragma once

#include "core/logs/array.h"
#include "core/logs/log.h"

namespace handmap {

/// Arrays by name; a .npy has one without a name. By role, by name, else by shape: N × B ranges,
/// N × P × 2 to 4 points, N × 3 poses (x y heading), N × 4 poses with the time first, N × 8 in TUM
/// form, N times.
void addArrays(const std::map<std::string, Array>& arrays, const std::string& file,
               const LogOptions& options, Log& log);

}  // namespace handmap
