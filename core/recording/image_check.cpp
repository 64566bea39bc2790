#include "core/recording/image_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/recording/image_file.h"

namespace handmap {

namespace {

constexpr double kSamples = 8000.0;
constexpr int kBlack = 8;
constexpr int kSaturated = 250;
constexpr int kEdge = 10;            // grey levels over two pixels: above the noise of a sensor
constexpr double kMinEdges = 0.001;  // shares of the samples
constexpr double kMaxBlack = 0.95;
constexpr double kMaxSaturated = 0.6;

constexpr int kSwapWidth_px = 320;   // disparities at that width decide
constexpr int kMinDisparity_px = 2;  // a small error of the calibration is less
constexpr int kPatch_px = 4;         // half of it
constexpr int kMaxCorners = 150;
constexpr double kUnlike = 15.0;     // mean absolute difference, grey levels
constexpr double kAmbiguous = 0.75;  // best over second best
constexpr int kMinVotes = 15;
constexpr double kMajority = 0.8;

cv::Mat reducedGrey(const cv::Mat& image) {
  const double scale = std::min(1.0, static_cast<double>(kSwapWidth_px) / image.cols);
  cv::Mat small;
  cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  return greyImage(small);
}

double difference(const cv::Mat& left, cv::Point at, const cv::Mat& right, cv::Point other) {
  int sum = 0;
  for (int dy = -kPatch_px; dy <= kPatch_px; ++dy) {
    const auto* a = left.ptr<std::uint8_t>(at.y + dy) + at.x;
    const auto* b = right.ptr<std::uint8_t>(other.y + dy) + other.x;
    for (int dx = -kPatch_px; dx <= kPatch_px; ++dx) sum += std::abs(a[dx] - b[dx]);
  }
  return sum / static_cast<double>((2 * kPatch_px + 1) * (2 * kPatch_px + 1));
}

/// How far left of `at` its place in the right image is, looked for on both sides; 0 where that is
/// not clear.
int disparityAt(const cv::Mat& left, const cv::Mat& right, cv::Point at) {
  const int reach = left.cols / 4;
  std::vector<double> costs(static_cast<std::size_t>(2 * reach + 1),
                            std::numeric_limits<double>::infinity());
  for (int d = -reach; d <= reach; ++d) {
    const int x = at.x - d;
    if (x < kPatch_px || x >= right.cols - kPatch_px) continue;
    double& cost = costs[static_cast<std::size_t>(d + reach)];
    for (const int y : {at.y - 1, at.y, at.y + 1}) {
      cost = std::min(cost, difference(left, at, right, {x, y}));
    }
  }
  const auto best = std::min_element(costs.begin(), costs.end());
  if (*best > kUnlike) return 0;
  for (auto other = costs.begin(); other != costs.end(); ++other) {
    if (std::abs(other - best) > 2 && *best > kAmbiguous * *other) return 0;
  }
  return static_cast<int>(best - costs.begin()) - reach;
}

}  // namespace

void checkPicture(const cv::Mat& image, const std::string& file) {
  const double pixels = static_cast<double>(image.total());
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / kSamples)));
  const int channels = image.channels();
  const int channel = channels / 2;  // green
  int samples = 0;
  int black = 0;
  int saturated = 0;
  int edges = 0;
  for (int y = 0; y < image.rows; y += step) {
    const auto* row = image.ptr<std::uint8_t>(y) + channel;
    for (int x = 0; x + 2 < image.cols; x += step) {
      const int value = row[x * channels];
      ++samples;
      black += value <= kBlack;
      saturated += value >= kSaturated;
      edges += std::abs(row[(x + 2) * channels] - value) > kEdge;
    }
  }
  if (samples == 0) throwBadInput(file, "", phrase("hardly a pixel"), phrase("a picture"));
  const auto share = [samples](int count) { return static_cast<double>(count) / samples; };
  if (share(saturated) > kMaxSaturated) {
    throwBadInput(file, "", phrase("{:.0f} % of the pixels saturated", 100 * share(saturated)),
                  phrase("at most {:.0f} %: overexposed", 100 * kMaxSaturated));
  }
  if (share(black) > kMaxBlack) {
    throwBadInput(file, "", phrase("{:.0f} % of the pixels black", 100 * share(black)),
                  phrase("at most {:.0f} %: dark, or the camera is covered", 100 * kMaxBlack));
  }
  if (share(edges) < kMinEdges) {
    throwBadInput(file, "", phrase("no contrast"), phrase("a picture: the camera looks covered"));
  }
}

void SwapCheck::operator()(const cv::Mat& left, const cv::Mat& right, const std::string& file) {
  if (pairs_left_ <= 0) return;
  const cv::Mat l = reducedGrey(left);
  const cv::Mat r = reducedGrey(right);
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(l, corners, kMaxCorners, 0.01, 4.0);
  int right_way = 0;
  int wrong_way = 0;
  const int border = kPatch_px + 1;
  for (const cv::Point at : std::vector<cv::Point>(corners.begin(), corners.end())) {
    if (at.x < border || at.y < border || at.x >= l.cols - border || at.y >= l.rows - border) {
      continue;
    }
    const int disparity = disparityAt(l, r, at);
    right_way += disparity >= kMinDisparity_px;
    wrong_way += disparity <= -kMinDisparity_px;
  }
  const double votes = right_way + wrong_way;
  if (votes >= kMinVotes && wrong_way > kMajority * votes) {
    throwBadInput(
        file, "",
        phrase("{} of {:.0f} matches farther right than in the left image", wrong_way, votes),
        phrase("them farther left: left and right look swapped"));
  }
  pairs_left_ -= votes >= kMinVotes && right_way > kMajority * votes ? 4 : 1;
}

}  // namespace handmap
