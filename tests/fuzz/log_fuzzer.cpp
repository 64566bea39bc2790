// Logs of other programs: CARMEN, tables, poses, arrays of numpy. The first byte is the kind.
#include <array>
#include <cmath>
#include <fstream>

#include "core/logs/log.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kKinds = {".log", ".csv", ".tum", ".npy", ".npz"};
  if (size == 0) return 0;
  const auto path = std::filesystem::temp_directory_path() /
                    fmt::format("handmap-fuzz-{}{}", getpid(), kKinds[data[0] % kKinds.size()]);
  std::ofstream(path, std::ios::binary) << fuzz::textOf(data + 1, size - 1);
  const int result = fuzz::takenOrRefused([&] {
    const Log log = readLogs({path}, {.rate_hz = 10.0});
    for (const LoggedScan& scan : log.scans) {
      fuzz::require(std::isfinite(scan.time_s));
      for (const RangePoint& point : scan.points) {
        fuzz::require(std::isfinite(point.x + point.y + point.z + point.w));
      }
    }
  });
  std::filesystem::remove(path);
  return result;
}
