// Building classifiers: one that is read is written and read again, and judges an image.
#include "core/classification/building_classifier.h"
#include "tests/fuzz/fuzz.h"

using namespace handmap;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::takenOrRefused([&] {
    const auto model = BuildingClassifier::parse(fuzz::textOf(data, size), "model");
    const std::string text = model.toJson();
    fuzz::require(BuildingClassifier::parse(text, "again").toJson() == text);
    const cv::Mat image(32, 32, model.features().colour ? CV_8UC3 : CV_8UC1, cv::Scalar::all(77));
    const cv::Mat1f probabilities = model.probabilities(image);
    for (const float p : probabilities) fuzz::require(p >= 0.0F && p <= 1.0F);
  });
}
