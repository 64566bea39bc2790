// What run --report wrote, in a report of a drawing that is good: as a page, and printed.
#include "core/report/report.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Building house;
  house.id = "A";
  house.shape = Rectangle{{10.0, 20.0}, 8.0, 6.0, 0.3};
  house.estimate = Estimate{0.2, 0.3, 0.4, 7};
  ReportInputs inputs;
  inputs.drawing.buildings = inputs.refined.buildings = {house};
  inputs.run = fuzz::textOf(data, size);
  inputs.run_file = "report.json";
  fuzz::takenOrRefused([&] {
    const std::string page = reportHtml(inputs);
    fuzz::require(page.find("</html>") != page.npos);
  });
  return fuzz::takenOrRefused([&] { fuzz::require(reportPdf(inputs).starts_with("%PDF")); });
}
