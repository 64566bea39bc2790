// How a building classifier is made from windows that are known.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/classification/building_classifier.h"
#include "core/classification/window_labels.h"

namespace handmap {

/// The known windows of images.
class TrainingSet {
 public:
  explicit TrainingSet(FeatureSet features) : features_(features) {}

  /// One label a whole window. Unknown ones are left out. Errors as windowFeatures(), and BadInput
  /// beyond two million windows.
  void add(const cv::Mat& image, const std::vector<WindowLabel>& labels);

  const FeatureSet& features() const { return features_; }
  /// Image by image, in each column by column: neighbours in the image are near each other.
  Eigen::Map<const SampleMatrix> samples() const {
    return {values_.data(), static_cast<Eigen::Index>(buildings_.size()), featureCount(features_)};
  }
  const std::vector<bool>& buildings() const { return buildings_; }

 private:
  FeatureSet features_;
  std::vector<float> values_;  ///< sample by sample
  std::vector<bool> buildings_;
};

struct TrainingOptions {
  std::uint64_t seed = 1;
  int vectors = 240;  ///< of the support vector machine; the time of a window is proportional
  int folds = 5;
  /// In place of the support vector machine: better in real streets when real streets elsewhere
  /// are learnt from, most with FeatureFamily::Equalized; worse when rendered ones are.
  bool trees = false;
};

/// Standardizes, chooses γ and C by cross-validation (trees have neither), fits the probabilities
/// to the distances of the folds that were held out, and trains with all. A fold is one stretch of
/// the images of each class, so that windows are judged by what was learnt from other images, or
/// other parts of the image. nullopt once `stop` was requested. `progress` is told the share done,
/// from this thread. The same set and options give the same classifier.
///
/// Trained with about 3,000 windows of each class (trees 10,000), evenly from all, judged by up to
/// 30,000; a stop takes half a second then (trees a second).
///
/// Throws BadInput where there are fewer windows of a class than folds.
std::optional<BuildingClassifier> trainClassifier(const TrainingSet& set,
                                                  const TrainingOptions& options,
                                                  const std::stop_token& stop = {},
                                                  const std::function<void(double)>& progress = {});

/// Adds how the windows of an image that are known are judged: building from p = 0.5 on.
void judge(const BuildingClassifier& classifier, const cv::Mat& image,
           const std::vector<WindowLabel>& labels, Confusion& confusion);

}  // namespace handmap
