// Files of range points.
#include <cmath>

#include "core/recording/recording.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const auto points = readPoints(fuzz::File(fuzz::textOf(data, size)).path());
    fuzz::require(points.size() * 12 <= size);  // what is no number is left out, w may be
    for (const RangePoint& point : points) fuzz::require(std::isfinite(point.x + point.w));
  });
}
