// PNG and JPEG files.
#include "core/recording/image_check.h"
#include "core/recording/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const cv::Mat image = readImage(fuzz::File(fuzz::textOf(data, size)).path());
    fuzz::require(!image.empty() && image.total() <= 64'000'000);
    checkPicture(image, "image");
  });
}
