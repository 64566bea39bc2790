// Which of the walls that stereo sees are of buildings (paper, II-A).
#pragma once

#include <memory>
#include <vector>

#include "core/classification/window_classifier.h"
#include "core/perception/wall_columns.h"

namespace handmap {

class WallJudge {
 public:
  /// nullptr: the classifiers that come with the program, for grey and for colour images.
  explicit WallJudge(std::shared_ptr<const WindowClassifier> classifier);

  /// Writes the probability of its windows into every wall; `columns` in pixels of an image of the
  /// size `seen`, the same view as `image` (8 bit, grey or BGR). Returns the probability of each
  /// window, 0.5 where it was not asked for. Throws BadInput for an image that the classifier
  /// cannot judge.
  cv::Mat1f operator()(const cv::Mat& image, cv::Size seen, std::vector<WallColumn>& columns);

 private:
  const WindowClassifier& classifierFor(const cv::Mat& image);

  std::shared_ptr<const WindowClassifier> classifier_;
  std::unique_ptr<const WindowClassifier> for_grey_, for_colour_;  ///< those of the program
};

}  // namespace handmap
