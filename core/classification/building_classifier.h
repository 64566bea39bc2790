// Which windows of an image show a building, section II-A.
#pragma once

#include <filesystem>
#include <string>
#include <variant>

#include <opencv2/core/mat.hpp>

#include "core/classification/confusion.h"
#include "core/classification/kernel_svm.h"
#include "core/classification/logistic.h"
#include "core/classification/random_trees.h"
#include "core/classification/standardization.h"
#include "core/classification/window_classifier.h"
#include "core/classification/window_features.h"

namespace handmap {

/// What parts buildings from the rest.
using Separator = std::variant<KernelSvm, RandomTrees>;

/// What a classifier was made from, kept in its file.
struct TrainingRecord {
  std::uint64_t seed = 0;
  double gamma = 0.0;  ///< SvmOptions; 0 of trees
  double c = 0.0;
  Confusion cross_validated;
};

class BuildingClassifier : public WindowClassifier {
 public:
  BuildingClassifier(FeatureSet features, Standardization standardization, Separator separator,
                     Logistic logistic, TrainingRecord record);

  /// Throws BadInput "FILE: key: found …, expected …": not a model, of another version or window
  /// size, damaged, numbers that are not finite.
  static BuildingClassifier load(const std::filesystem::path& path);
  /// `source` names the text in messages.
  static BuildingClassifier parse(std::string_view text, const std::string& source);
  /// The one that comes with the program, for colour or for grey images: trained on rendered
  /// streets (resources/models).
  static BuildingClassifier builtIn(bool colour);
  std::string toJson() const;
  /// Throws RunFailed.
  void save(const std::filesystem::path& path) const;

  /// If buildings and the rest were equally frequent; of equalized features jointlyFiltered().
  /// `image` and errors as windowFeatures().
  cv::Mat1f probabilities(const cv::Mat& image, const cv::Mat1b& wanted = {}) const override;

  const FeatureSet& features() const { return features_; }
  const TrainingRecord& record() const { return record_; }

 private:
  FeatureSet features_;
  Standardization standardization_;
  Separator separator_;
  Logistic logistic_;
  TrainingRecord record_;
};

}  // namespace handmap
