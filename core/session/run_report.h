// The JSON that a run leaves: the report (FORMATS 3) and the "refinement" object of the map.
#pragma once

#include <string>
#include <vector>

#include "core/session/run_session.h"

namespace handmap {

/// Depends on nothing but what decides the result: no times, no number of threads.
std::string refinementJson(const RunSettings& settings, const SourceInfo& source,
                           const std::vector<FrameReport>& frames);

/// What a run leaves at its end.
struct RunRecord {
  const RunSettings& settings;
  const SourceInfo& source;
  const std::vector<FrameReport>& frames;
  const std::vector<SkippedFrame>& skipped;
  const std::vector<RunWarning>& warnings;
  const Map& refined;
  double wall_s;
  double peak_memory_mb;
};

std::string runReportJson(const RunRecord& run);

}  // namespace handmap
