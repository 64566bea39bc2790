// The page that shows a report, without its data: page.html.
#pragma once

#include <string_view>

namespace handmap {

extern const std::string_view kReportPage;

}  // namespace handmap
