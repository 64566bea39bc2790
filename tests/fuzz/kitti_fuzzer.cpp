// The files of a KITTI sequence and of a drive of its raw data; the first byte tells which.
#include <cmath>

#include "core/kitti_raw/kitti_files.h"
#include "core/recording/calibration.h"
#include "core/recording/kitti_folder.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  return fuzz::takenOrRefused([&] {
    const fuzz::File file(fuzz::textOf(data + 1, size - 1));
    if (data[0] == 'c') {
      const StereoCamera camera = readCalibration(file.path(), "P0", "P1", {});
      fuzz::require(camera.fx > 0.0 && camera.baseline > 0.0 && std::isfinite(camera.mount.y));
    } else if (data[0] == 't') {
      fuzz::require(!readKittiTimes(file.path()).empty());
    } else if (data[0] == 's') {
      for (const double time_s : readKittiTimestamps(file.path())) {
        fuzz::require(std::isfinite(time_s));
      }
    } else if (data[0] == 'r') {
      const KittiCalibration calibration(file.path());
      fuzz::require(calibration.transform().matrix().allFinite());
    } else if (data[0] == 'o') {
      fuzz::require(std::isfinite(readKittiFix(file.path()).heading));
    } else if (data[0] == 'v') {
      for (const RangePoint& p : readKittiScan(file.path(), 1)) {
        fuzz::require(std::isfinite(p.x + p.y + p.z));
      }
    } else {
      const auto poses = readKittiPoses(file.path(), {0.0, 1.0}).poses();
      fuzz::require(poses.size() == 2 && std::isfinite(poses.back().pose.heading));
    }
  });
}
