#include "core/classification/window_features.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/classification/window_labels.h"
#include "tests/core/base/expect_error.h"
#include "tests/core/classification/painted_street.h"

namespace handmap {
namespace {

constexpr FeatureSet kAll[] = {{FeatureFamily::Paper, true},     {FeatureFamily::Paper, false},
                               {FeatureFamily::Handmap, true},   {FeatureFamily::Handmap, false},
                               {FeatureFamily::Equalized, true}, {FeatureFamily::Equalized, false}};

TEST(WindowFeatures, AreAsManyAsSaidAndFinite) {
  const cv::Mat3b image = test::paintStreet(1).image;
  for (const FeatureSet& set : kAll) {
    const SampleMatrix features = windowFeatures(image, set);
    EXPECT_EQ(features.rows(), 80);
    EXPECT_EQ(features.cols(), featureCount(set));
    EXPECT_TRUE(features.allFinite());
  }
  EXPECT_EQ(featureCount(kAll[0]), 6);
}

TEST(WindowFeatures, OfThePaperAreColourAndEdges) {
  cv::Mat3b image(16, 32, cv::Vec3b(20, 60, 120));
  image(cv::Rect(16, 0, 8, 16)) = cv::Vec3b(200, 200, 200);
  const SampleMatrix features = windowFeatures(image, kAll[0]);
  EXPECT_NEAR(features(0, 0), 121.0 / 203.0, 1e-5);  // red first
  EXPECT_NEAR(features(0, 1), 61.0 / 203.0, 1e-5);
  EXPECT_NEAR(features(0, 2), 200.0 / 765.0, 1e-5);
  EXPECT_NEAR(features(1, 3), 3.0 / 16.0, 1e-5);  // two of the step, one of the one at the left
  EXPECT_NEAR(features(1, 4), 1.0, 1e-5);
  EXPECT_NEAR(features(1, 5), 0.0, 1e-5);
}

TEST(WindowFeatures, OfAMirroredImageAreMirrored) {
  const cv::Mat3b image = test::paintStreet(2).image;
  cv::Mat3b mirrored;
  cv::flip(image, mirrored, 1);
  for (const FeatureSet& set : kAll) {
    const SampleMatrix features = windowFeatures(image, set);
    const SampleMatrix others = windowFeatures(mirrored, set);
    const int columns = image.cols / kWindow_px;
    for (int i = 0; i < features.rows(); ++i) {
      const int other = i / columns * columns + columns - 1 - i % columns;
      // Votes on the border between two lines may fall to the other side.
      EXPECT_LT((features.row(i) - others.row(other)).cwiseAbs().maxCoeff(), 0.08F) << i;
    }
  }
}

TEST(WindowFeatures, OfAnEqualizedImageAreTheSameAtDusk) {
  const cv::Mat3b noon = test::paintStreet(2).image;
  cv::Mat1b curve(1, 256);  // rises at every level that the street has
  for (int level = 0; level < 256; ++level) {
    curve(level) = cv::saturate_cast<std::uint8_t>(level < 60 ? level / 2 : level - 30);
  }
  cv::Mat3b dusk;
  cv::LUT(noon, curve, dusk);
  const auto difference = [&](FeatureFamily family) {
    return (windowFeatures(noon, {family, false}) - windowFeatures(dusk, {family, false}))
        .cwiseAbs()
        .mean();
  };
  EXPECT_LT(difference(FeatureFamily::Equalized), 0.2F * difference(FeatureFamily::Handmap));
}

TEST(WindowFeatures, RefuseWhatTheyAreNotFor) {
  using test::expectBadInput;
  expectBadInput([] { windowFeatures(cv::Mat1b(32, 32, std::uint8_t{0}), {}); }, {"found grey"});
  expectBadInput([] { windowFeatures(cv::Mat3b(15, 32), {}); }, {"32 × 15 pixels", "16 × 16"});
  expectBadInput([] { windowFeatures(cv::Mat(32, 32, CV_16UC3), {}); }, {"16 bits"});
  expectBadInput([] { windowFeatures(cv::Mat(32, 32, CV_8UC4), {}); }, {"4 channels"});
}

TEST(WindowLabels, AreThoseOfMostPixels) {
  cv::Mat1b classes(32, 40, std::uint8_t{3});
  classes(cv::Rect(0, 0, 9, 16)) = 1;
  classes(cv::Rect(16, 0, 7, 16)) = 1;
  classes(cv::Rect(16, 16, 16, 16)) = 11;
  using enum WindowLabel;
  EXPECT_EQ(windowLabels(classes, 1, 11), (std::vector{Building, Other, Other, Unknown}));
  EXPECT_EQ(windowLabels(classes, 3, {}), (std::vector{Other, Building, Building, Other}));
}

TEST(WindowGrid, KnowsTheWindowOfEveryPixel) {
  const WindowGrid grid = WindowGrid::of({40, 33});
  EXPECT_EQ(grid.count(), 4);
  EXPECT_EQ(grid.at(15, 16), cv::Point(0, 1));
  EXPECT_EQ(grid.at(39, 32), cv::Point(1, 1));  // left over
  EXPECT_EQ(grid.at(-1, 99), cv::Point(0, 1));
  const cv::Mat1f values = (cv::Mat1f(2, 2) << 1, 2, 3, 4);
  EXPECT_EQ(valueAt(values, 20, 3), 2.0F);
  EXPECT_EQ(valueAt(values, 39, 32), 4.0F);
}

}  // namespace
}  // namespace handmap
