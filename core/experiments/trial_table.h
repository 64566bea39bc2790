// Trials as text: one a line, below a line with the settings and one with the names of the columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/experiments/trial.h"

namespace handmap {

/// "handmap" or "paper".
const char* nameOf(Method method);

/// The two lines that a table begins with.
std::string trialTableHead(const TrialSettings& settings);
/// With the line end. Metres to the millimetre: a report made from the text is the same as ever.
std::string trialLine(const Trial& trial);

/// The trials of a table. What follows the last line end is a line that was not finished, and is
/// left out. Throws BadInput, naming `source` and the line: other settings, or a damaged table.
std::vector<Trial> parseTrials(std::string_view text, const std::string& source,
                               const TrialSettings& settings);

}  // namespace handmap
