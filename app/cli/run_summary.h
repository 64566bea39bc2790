// The result of a run in words.
#pragma once

#include <string>

#include "core/session/run_session.h"

namespace handmap {

/// The last pose, a row a building, and what all are off by together (see CommonShift); equal runs
/// give equal bytes.
std::string runSummary(const Map& drawing, const RunSession& session);
/// The same for programs: {"observations", "skipped", "pose", "buildings", "common_shift",
/// "warnings"}.
std::string runSummaryJson(const Map& drawing, const RunSession& session);

}  // namespace handmap
