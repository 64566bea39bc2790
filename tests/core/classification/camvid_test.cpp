// How well buildings are found in real streets: taught with a part of the training images, judged
// by images that were not seen.
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "core/classification/labelled_folder.h"
#include "core/classification/training.h"

namespace handmap {
namespace {

const std::filesystem::path kCamVid = std::filesystem::path(HANDMAP_SHARED_DATA) / "camvid";
constexpr int kVoid = 11;

Confusion judged(const BuildingClassifier& classifier) {
  Confusion seen;
  forEachLabelled({kCamVid / "val", kCamVid / "valannot", 1, kVoid},
                  [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double) {
                    judge(classifier, image, labels, seen);
                  });
  std::cout << "  balanced accuracy " << seen.balancedAccuracy() << ", precision "
            << seen.precision() << ", recall " << seen.recall() << ", F1 " << seen.f1() << "\n";
  return seen;
}

Confusion taughtAndJudged(const FeatureSet& features) {
  TrainingSet set(features);
  int image_number = 0;
  forEachLabelled({kCamVid / "train", kCamVid / "trainannot", 1, kVoid},
                  [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double) {
                    if (image_number++ % 3 == 0) set.add(image, labels);
                  });
  return judged(trainClassifier(set, {.vectors = 120}).value());
}

TEST(CamVid, BuildingsAreFoundInColourAndInGrey) {
  if (!std::filesystem::exists(kCamVid)) GTEST_SKIP() << "no CamVid images";
  EXPECT_GT(taughtAndJudged({}).balancedAccuracy(), 0.90);
  EXPECT_GT(taughtAndJudged({FeatureFamily::Handmap, false}).balancedAccuracy(), 0.89);
}

TEST(CamVid, TheModelsOfTheProgramHaveNeverSeenARealStreet) {
  if (!std::filesystem::exists(kCamVid)) GTEST_SKIP() << "no CamVid images";
  EXPECT_GT(judged(BuildingClassifier::builtIn(true)).balancedAccuracy(), 0.82);
  EXPECT_GT(judged(BuildingClassifier::builtIn(false)).balancedAccuracy(), 0.79);
}

}  // namespace
}  // namespace handmap
