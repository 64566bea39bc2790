#include "core/perception/wall_judge.h"

#include "core/classification/building_classifier.h"
#include "core/classification/windows.h"

namespace handmap {

namespace {

/// Calls `use` with each window that shows a part of the wall.
template <typename Use>
void forWindows(const WallColumn& wall, cv::Size image, cv::Size seen, Use use) {
  const WindowGrid grid = WindowGrid::of(image);
  const double per_column = static_cast<double>(image.width) / seen.width;
  const double per_row = static_cast<double>(image.height) / seen.height;
  const int x = static_cast<int>((wall.column + 0.5) * per_column);
  const cv::Point top = grid.at(x, static_cast<int>((wall.row - wall.half_rows) * per_row));
  const cv::Point bottom = grid.at(x, static_cast<int>((wall.row + wall.half_rows) * per_row));
  for (cv::Point window = top; window.y <= bottom.y; ++window.y) use(window);
}

}  // namespace

WallJudge::WallJudge(std::shared_ptr<const WindowClassifier> classifier)
    : classifier_(std::move(classifier)) {}

const WindowClassifier& WallJudge::classifierFor(const cv::Mat& image) {
  if (classifier_) return *classifier_;
  const bool colour = image.channels() == 3;
  auto& built_in = colour ? for_colour_ : for_grey_;
  if (!built_in)
    built_in = std::make_unique<BuildingClassifier>(BuildingClassifier::builtIn(colour));
  return *built_in;
}

cv::Mat1f WallJudge::operator()(const cv::Mat& image, cv::Size seen,
                                std::vector<WallColumn>& columns) {
  cv::Mat1b wanted = noWindows(image.size());
  for (const WallColumn& wall : columns) {
    forWindows(wall, image.size(), seen, [&](cv::Point window) { wanted(window) = 1; });
  }
  cv::Mat1f probabilities = classifierFor(image).probabilities(image, wanted);
  for (WallColumn& wall : columns) {
    double sum = 0.0;
    int windows = 0;
    forWindows(wall, image.size(), seen, [&](cv::Point window) {
      sum += static_cast<double>(probabilities(window));
      ++windows;
    });
    wall.building = sum / windows;
  }
  return probabilities;
}

}  // namespace handmap
