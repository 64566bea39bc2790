#include "core/report/page.h"
#include "core/report/report_data.h"

namespace handmap {

std::string reportHtml(const ReportInputs& inputs) {
  // Nothing in it ends the element that it stands in.
  std::string data;
  for (const char c :
       reportData(inputs).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<') {
      data += "\\u003c";
    } else {
      data += c;
    }
  }
  std::string page(kReportPage);
  constexpr std::string_view kPlace = "{\"place\": \"of the data\"}";
  return page.replace(page.find(kPlace), kPlace.size(), data);
}

}  // namespace handmap
