// Calibrations of OpenCV; small images are rectified by them.
#include "core/recording/rectifier.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr int kSmall_px = 10'000;  // time and memory grow with the image
  return fuzz::takenOrRefused([&] {
    const fuzz::File file(fuzz::textOf(data, size));
    const StereoCalibration calibration = readStereoCalibration(file.path());
    if (calibration.size.area() > kSmall_px) return;
    const Rectifier rectifier(calibration, "calibration");
    const cv::Mat1b image(calibration.size, 128);
    fuzz::require(rectifier.left(image).size() == calibration.size);
    fuzz::require(rectifier.camera({}).baseline > 0.0);
  });
}
