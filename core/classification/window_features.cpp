#include "core/classification/window_features.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/classification/edge_statistics.h"
#include "core/classification/equalization.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

/// What features are taken of: itself, 3×3, 9×9; the row, or above and below.
int aroundCount(const FeatureSet& set) { return set.family == FeatureFamily::Equalized ? 4 : 5; }

/// Of the place in the image.
int placeCount(const FeatureSet& set) { return set.family == FeatureFamily::Equalized ? 1 : 2; }

/// Features of a window by itself.
int ownCount(const FeatureSet& set) {
  if (set.family == FeatureFamily::Paper) return set.colour ? 6 : 5;
  return set.colour ? 15 : 11;
}

/// Appends values one after another.
class Writer {
 public:
  explicit Writer(float* to) : to_(to) {}
  void operator()(float value) { *to_++ = value; }

 private:
  float* to_;
};

void writeEdges(const EdgeStatistics& edges, Writer& write) {
  write(edges.density);
  write(edges.hough_peak);
  write(edges.direction_variance);
}

/// Contrast and the rest of the edges; directions that mirror each other count as one.
void writeMoreEdges(const EdgeStatistics& edges, Writer& write) {
  write(edges.contrast);
  write(edges.strength);
  write(edges.directions[0]);
  for (std::size_t i = 1; i < kEdgeDirections / 2; ++i) {
    write(edges.directions[i] + edges.directions[kEdgeDirections - i]);
  }
  write(edges.directions[kEdgeDirections / 2]);
}

void writeColour(const cv::Vec3b& bgr, bool more, Writer& write) {
  const float sum = static_cast<float>(bgr[0] + bgr[1] + bgr[2]) + 3.0F;
  const auto share = [&](int channel) { return (static_cast<float>(bgr[channel]) + 1.0F) / sum; };
  write(share(2));
  write(share(1));
  if (more) write(share(0));
  write((sum - 3.0F) / 765.0F);
  if (!more) return;
  const auto [least, greatest] = std::minmax({bgr[0], bgr[1], bgr[2]});
  write(static_cast<float>(greatest - least) / (static_cast<float>(greatest) + 1.0F));
}

/// Of every window by itself: rows × columns, as many channels as features.
cv::Mat ownFeatures(const cv::Mat& image, const cv::Mat1b& grey, const FeatureSet& set) {
  const WindowGrid grid = WindowGrid::of(grey.size());
  const cv::Rect whole(0, 0, grid.columns * kWindow_px, grid.rows * kWindow_px);
  const bool more = set.family != FeatureFamily::Paper;
  const std::vector<EdgeStatistics> edges = edgeStatistics(grey);
  cv::Mat mean;  // colour or brightness
  cv::resize((set.colour ? image : cv::Mat(grey))(whole), mean, {grid.columns, grid.rows}, 0, 0,
             cv::INTER_AREA);

  const int count = ownCount(set);
  cv::Mat features(grid.rows, grid.columns, CV_32FC(count));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const EdgeStatistics& own = edges[static_cast<std::size_t>(row * grid.columns + column)];
      Writer write(features.ptr<float>(row) + static_cast<std::ptrdiff_t>(column) * count);
      if (set.colour) {
        writeColour(mean.at<cv::Vec3b>(row, column), more, write);
      } else {
        write(static_cast<float>(mean.at<std::uint8_t>(row, column)) / 255.0F);
        if (!more) write(own.contrast);
      }
      writeEdges(own, write);
      if (more) writeMoreEdges(own, write);
    }
  }
  return features;
}

/// Beside the features of each window those of what is around it, and its place.
SampleMatrix withSurroundings(const cv::Mat& own, const FeatureSet& set) {
  cv::Mat near;
  cv::Mat far;
  cv::blur(own, near, {3, 3}, {-1, -1}, cv::BORDER_REPLICATE);
  cv::blur(own, far, {9, 9}, {-1, -1}, cv::BORDER_REPLICATE);
  const bool equalized = set.family == FeatureFamily::Equalized;
  const int count = own.channels();
  SampleMatrix samples(own.rows * own.cols, featureCount(set));
  for (int row = 0; row < own.rows; ++row) {
    const float* above = near.ptr<float>(std::max(row - 2, 0));
    const float* below = near.ptr<float>(std::min(row + 2, own.rows - 1));
    const Eigen::RowVectorXf mean =
        Eigen::Map<const SampleMatrix>(own.ptr<float>(row), own.cols, count).colwise().mean();
    for (int column = 0; column < own.cols; ++column) {
      float* to = samples.row(static_cast<Eigen::Index>(row) * own.cols + column).data();
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(column) * count;
      const auto write = [&](const float* from) { to = std::copy_n(from, count, to); };
      write(own.ptr<float>(row) + at);
      write(near.ptr<float>(row) + at);
      write(far.ptr<float>(row) + at);
      if (equalized) {
        write(mean.data());
      } else {
        write(above + at);
        write(below + at);
      }
      *to++ = (static_cast<float>(row) + 0.5F) / static_cast<float>(own.rows);
      if (equalized) continue;
      *to = std::abs((static_cast<float>(column) + 0.5F) / static_cast<float>(own.cols) - 0.5F);
    }
  }
  return samples;
}

void checkImage(const cv::Mat& image, const FeatureSet& set) {
  const std::string place = phrase("building classifier");
  if (image.depth() != CV_8U || (image.channels() != 1 && image.channels() != 3)) {
    throwBadInput(place, phrase("image"),
                  phrase("{} channels of {} bits", image.channels(), 8 * image.elemSize1()),
                  phrase("1 or 3 channels of 8 bits"));
  }
  if (set.colour && image.channels() != 3) {
    throwBadInput(place, phrase("image"), phrase("grey"),
                  phrase("colour, or a model for grey images"));
  }
  if (WindowGrid::of(image.size()).count() == 0) {
    throwBadInput(place, phrase("image"), phrase("{} × {} pixels", image.cols, image.rows),
                  phrase("at least {0} × {0}", kWindow_px));
  }
}

}  // namespace

std::string_view nameOf(FeatureFamily family) {
  switch (family) {
    case FeatureFamily::Paper:
      return "paper";
    case FeatureFamily::Handmap:
      return "handmap";
    case FeatureFamily::Equalized:
      return "equalized";
  }
  return {};
}

int featureCount(const FeatureSet& set) {
  const int own = ownCount(set);
  return set.family == FeatureFamily::Paper ? own : aroundCount(set) * own + placeCount(set);
}

SampleMatrix windowFeatures(const cv::Mat& image, const FeatureSet& set) {
  checkImage(image, set);
  const cv::Mat seen = set.family == FeatureFamily::Equalized ? equalized(image) : image;
  const cv::Mat own = ownFeatures(seen, greyImage(seen), set);
  if (set.family != FeatureFamily::Paper) return withSurroundings(own, set);
  return Eigen::Map<const SampleMatrix>(own.ptr<float>(), own.rows * own.cols, own.channels());
}

}  // namespace handmap
