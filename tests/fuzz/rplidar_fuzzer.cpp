// Bytes of an RPLIDAR, after the descriptor of one of its three kinds of scan.
#include <cmath>

#include "drivers/scanner/rplidar_protocol.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  RplidarReader reader;
  RplidarTurns turns;
  const char kinds[] = {'\x81', '\x82', '\x85', '\x04'};
  const char kind = kinds[data[0] % 4];
  std::string bytes{'\xA5', '\x5A', kind == '\x81' ? '\x05' : '\x54', 0, 0, '\x40', kind};
  bytes += fuzz::textOf(data + 1, size - 1);
  for (std::size_t at = 0; at < bytes.size(); at += 50) {
    for (const auto& measurement :
         reader.feed(std::string_view(bytes).substr(at, 50)).measurements) {
      fuzz::require(measurement.angle_rad >= 0.0 && measurement.angle_rad < 6.2832);
      fuzz::require(measurement.range_m >= 0.0 && measurement.range_m < 100.0);
      if (const auto points = turns.add(measurement)) fuzz::require(points->size() <= 50'000);
    }
  }
  return 0;
}
