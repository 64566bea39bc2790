// What a report tells, whatever it is written as.
#pragma once

#include <nlohmann/json.hpp>

#include "core/report/report.h"

namespace handmap {

/// As the page has it (`page.html` reads it): title, buildings, frames, run, common, truth,
/// survey, pictures, files. Throws as reportHtml().
nlohmann::ordered_json reportData(const ReportInputs& inputs);

}  // namespace handmap
