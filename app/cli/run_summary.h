// The result of a run in words.
#pragma once

#include <string>

#include "core/session/run_session.h"

namespace handmap {

/// The last pose and a row a building; equal runs give equal bytes.
std::string runSummary(const RunSession& session);
/// The same for programs: {"observations", "skipped", "pose", "buildings", "warnings"}.
std::string runSummaryJson(const RunSession& session);

}  // namespace handmap
