// How well buildings are found in real streets: taught with a part of the training images, judged
// by images that were not seen.
#include <algorithm>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "core/classification/labelled_folder.h"
#include "core/classification/training.h"
#include "tests/core/base/temporary_folder.h"

namespace handmap {
namespace {

const std::filesystem::path kCamVid = std::filesystem::path(HANDMAP_SHARED_DATA) / "camvid";
constexpr int kVoid = 11;

Confusion judged(const BuildingClassifier& classifier, const LabelledFolder& folder) {
  Confusion seen;
  forEachLabelled(folder, [&](const cv::Mat& image, const std::vector<WindowLabel>& labels,
                              double) { judge(classifier, image, labels, seen); });
  std::cout << "  balanced accuracy " << seen.balancedAccuracy() << ", precision "
            << seen.precision() << ", recall " << seen.recall() << ", F1 " << seen.f1() << "\n";
  return seen;
}

Confusion judged(const BuildingClassifier& classifier) {
  return judged(classifier, {kCamVid / "val", kCamVid / "valannot", 1, kVoid});
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

/// The images of a sequence, or all others.
LabelledFolder linked(const std::filesystem::path& folder, const std::string& sequence,
                      bool of_sequence) {
  const LabelledFolder result{folder / "images", folder / "labels", 1, kVoid};
  for (const std::string part : {"train", "val"}) {
    for (const auto& image : std::filesystem::directory_iterator(kCamVid / part)) {
      const std::filesystem::path name = image.path().filename();
      if (name.string().starts_with(sequence) != of_sequence) continue;
      const std::filesystem::path labels = std::filesystem::path(name).replace_extension(".png");
      std::filesystem::create_directories(result.images);
      std::filesystem::create_directories(result.labels);
      std::filesystem::create_symlink(image.path(), result.images / name);
      std::filesystem::create_symlink(kCamVid / (part + "annot") / labels, result.labels / labels);
    }
  }
  return result;
}

/// How trees find buildings in a sequence that the two others taught.
double accuracyLeftOut(const std::string& sequence) {
  const test::TemporaryFolder folder;
  TrainingSet set({FeatureFamily::Equalized, true});
  forEachLabelled(linked(folder.path() / "others", sequence, false),
                  [&](const cv::Mat& image, const std::vector<WindowLabel>& labels, double) {
                    set.add(image, labels);
                  });
  return judged(trainClassifier(set, {.trees = true}).value(),
                linked(folder.path() / "left-out", sequence, true))
      .balancedAccuracy();
}

TEST(CamVid, TreesFindBuildingsInOtherPlacesAndOtherLight) {
  if (!std::filesystem::exists(kCamVid)) GTEST_SKIP() << "no CamVid images";
  const double dusk = accuracyLeftOut("0001TP");
  const double car_park = accuracyLeftOut("0006R0");
  const double noon = accuracyLeftOut("0016E5");
  EXPECT_GT(std::min({dusk, car_park, noon}), 0.86);
  EXPECT_GT((dusk + car_park + noon) / 3.0, 0.88);
}

TEST(CamVid, TheModelsOfTheProgramHaveNeverSeenARealStreet) {
  if (!std::filesystem::exists(kCamVid)) GTEST_SKIP() << "no CamVid images";
  EXPECT_GT(judged(BuildingClassifier::builtIn(true)).balancedAccuracy(), 0.82);
  EXPECT_GT(judged(BuildingClassifier::builtIn(false)).balancedAccuracy(), 0.79);
}

}  // namespace
}  // namespace handmap
