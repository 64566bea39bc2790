#include "core/classification/building_classifier.h"

#include <utility>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/classification/equalization.h"
#include "core/classification/joint_filter.h"
#include "core/recording/image_file.h"

namespace handmap {

BuildingClassifier::BuildingClassifier(FeatureSet features, Standardization standardization,
                                       Separator separator, Logistic logistic,
                                       TrainingRecord record)
    : features_(features),
      standardization_(std::move(standardization)),
      separator_(std::move(separator)),
      logistic_(logistic),
      record_(record) {}

cv::Mat1f BuildingClassifier::probabilities(const cv::Mat& image, const cv::Mat1b& wanted) const {
  const SampleMatrix samples = windowFeatures(image, features_);
  const WindowGrid grid = WindowGrid::of(image.size());
  if (!wanted.empty() && wanted.size() != cv::Size(grid.columns, grid.rows)) {
    throwBadInput(phrase("building classifier"), phrase("wanted windows"),
                  fmt::format("{} × {}", wanted.cols, wanted.rows),
                  fmt::format("{} × {}", grid.columns, grid.rows));
  }
  const bool filters = features_.family == FeatureFamily::Equalized;
  const bool all = wanted.empty() || (filters && cv::countNonZero(wanted) > 0);
  std::vector<Eigen::Index> judged;
  for (int i = 0; i < grid.count(); ++i) {
    if (all || wanted(i / grid.columns, i % grid.columns) != 0) judged.push_back(i);
  }
  cv::Mat1f result(grid.rows, grid.columns, 0.5F);
  if (judged.empty()) return result;
  const SampleMatrix standardized = standardization_(samples(judged, Eigen::all));
  const Eigen::VectorXf distances =
      std::visit([&](const auto& separator) { return separator.decide(standardized); }, separator_);
  for (std::size_t i = 0; i < judged.size(); ++i) {
    result.ptr<float>()[judged[i]] = logistic_(distances[static_cast<Eigen::Index>(i)]);
  }
  if (!filters) return result;
  result = jointlyFiltered(result, equalized(features_.colour ? image : greyImage(image)));
  if (!wanted.empty()) result.setTo(0.5F, wanted == 0);
  return result;
}

}  // namespace handmap
