// What is measured of every window, section II-A.
#pragma once

#include <string_view>

#include <opencv2/core/mat.hpp>

#include "core/classification/sample_matrix.h"
#include "core/classification/windows.h"

namespace handmap {

/// Paper: normalized colour (r, g; in place of b = 1 − r − g the brightness), edge density, peak of
/// the Hough voting, variance of the edge directions; without colour mean and deviation of the
/// brightness in its place.
/// Handmap: also b, saturation, contrast, strength and directions of the edges; all of
/// these also of the 3×3 and 9×9 windows around, of the 3×3 around the window two above and of
/// those around the window two below; the place in the image.
/// Equalized: the same of the image equalized(), but of the whole row of windows in place of what
/// is above and below, and of the place the height alone: holds better in other light and streets.
enum class FeatureFamily { Paper, Handmap, Equalized };

/// In files and options.
std::string_view nameOf(FeatureFamily family);

struct FeatureSet {
  FeatureFamily family = FeatureFamily::Handmap;
  bool colour = true;

  bool operator==(const FeatureSet&) const = default;
};

int featureCount(const FeatureSet& set);

/// One row a window, one column a feature. `image`: 8 bit, grey or BGR. Left and right are alike:
/// a mirrored image has mirrored features. Throws BadInput for an image of another kind, without
/// colours where the set has them, or smaller than a window.
SampleMatrix windowFeatures(const cv::Mat& image, const FeatureSet& set);

}  // namespace handmap
