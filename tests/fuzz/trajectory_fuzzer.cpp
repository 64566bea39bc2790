// TUM files: poses at all times between the first and the last.
#include <cmath>

#include "core/recording/trajectory.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const Trajectory trajectory = readTum(fuzz::File(fuzz::textOf(data, size)).path());
    const double from = trajectory.poses().front().time_s;
    const double to = trajectory.poses().back().time_s;
    for (const double share : {0.0, 0.3, 1.0}) {
      const auto pose = trajectory.at(std::lerp(from, to, share));
      fuzz::require(pose && std::isfinite(pose->x) && std::isfinite(pose->heading));
    }
    readTum(fuzz::File(formatTum(trajectory.poses())).path());
  });
}
