// Lines of odometry.
#include <cmath>

#include "drivers/odometry_lines/odometry_line.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const OdometryLine line = parseOdometryLine(fuzz::textOf(data, size));
    fuzz::require(std::isfinite(line.stamp_s) && std::abs(line.pose.x) <= 1e7 &&
                  std::abs(line.pose.y) <= 1e7 && std::abs(line.pose.heading) <= kPi);
  });
}
