// recording.json, beside good files.
#include <fstream>

#include "core/recording/recording.h"
#include "tests/core/base/temporary_folder.h"
#include "tests/core/recording/example_calibration.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

namespace {

/// A recording of one frame without its recording.json.
struct Example {
  Example() {
    StereoCalibration small = test::exampleCalibration();
    small.size = {64, 48};
    for (LensCalibration* lens : {&small.left, &small.right}) {
      lens->matrix = {52, 0, 32, 0, 52, 24, 0, 0, 1};
    }
    folder.write("frames.csv", "frame,time_s,stop,pan_deg,left,right,points\n0,0,,,a.png,b.png,\n");
    folder.write("calib.txt", "P0: 70 0 16 0 0 71 8 0 0 0 1 0\nP1: 70 0 16 -35 0 71 8 0 0 0 1 0\n");
    folder.write("calib.yml", formatStereoCalibration(small));
    folder.write("odometry.tum", "0 0 0 0 0 0 0 1\n");
  }
  test::TemporaryFolder folder;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Example kExample;
  kExample.folder.write("recording.json", fuzz::textOf(data, size));
  return fuzz::takenOrRefused([&] {
    const Recording recording = openRecording(kExample.folder.path());
    fuzz::require(recording.range_limit_m >= 1.0 && recording.range_limit_m <= 200.0);
    fuzz::require(recording.camera && recording.camera->baseline > 0.0);
  });
}
