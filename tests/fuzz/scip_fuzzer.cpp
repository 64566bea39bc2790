// Lines of a Hokuyo scanner; sums are mended, or hardly anything would pass.
#include <cmath>

#include "drivers/scanner/scip.h"
#include "drivers/serial/line_buffer.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  LineBuffer lines(300, true);
  ScipReader reader;
  ScipClock clock;
  ScipParameters parameters;
  int number = 0;
  lines.feed(fuzz::textOf(data, size), [&](std::string_view line) {
    const bool summed = ++number > 1 && !line.empty();
    if (line.empty()) number = 0;
    const auto answer = reader.take(summed ? std::string(line) + scipSum(line) : std::string(line));
    if (!answer) return;
    if (const auto read = parseScipParameters(*answer)) parameters = *read;
    if (const auto scan = parseScipScan(*answer, parameters)) {
      fuzz::require(std::isfinite(clock.seconds(scan->stamp_ms)));
      for (const RangePoint& point : scipPoints(*scan, parameters)) {
        fuzz::require(std::hypot(point.x, point.y) <= 300.0F);
      }
    }
  });
  return 0;
}
