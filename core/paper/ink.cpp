#include "core/paper/ink.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "core/base/median.h"
#include "core/paper/squares.h"

namespace handmap {

namespace {

constexpr int kReduced = 4;             // the light changes slowly
constexpr double kWindow = 0.08;        // of the longer side: of the median that is the bare paper
constexpr double kMargin = 0.003;       // of the longer side
constexpr double kShareOfStrong = 0.4;  // printed squares are fainter than the strokes by more
constexpr double kStrong = 0.98;        // quantile: printed squares may be most of what is seen
constexpr double kThickest = 0.015;     // of the longer side: a wider stroke is a blot
constexpr double kNoises = 6.0;
constexpr double kLeastInk = 1e-4;  // of the page

/// The channel in which ink of any colour stands out.
cv::Mat contrasting(const cv::Mat& page, bool dark_page) {
  if (page.channels() == 1) return page;
  std::vector<cv::Mat> channels;
  cv::split(page, channels);
  cv::Mat most = channels[0];
  for (std::size_t i = 1; i < channels.size(); ++i) {
    most = dark_page ? cv::Mat(cv::max(most, channels[i])) : cv::Mat(cv::min(most, channels[i]));
  }
  return most;
}

/// What the paper would look like without the ink.
cv::Mat barePaper(const cv::Mat& channel) {
  cv::Mat small;
  cv::resize(channel, small, {}, 1.0 / kReduced, 1.0 / kReduced, cv::INTER_AREA);
  const int window = std::max(3, static_cast<int>(kWindow * std::max(small.cols, small.rows)) | 1);
  cv::medianBlur(small, small, window);
  cv::Mat bare;
  cv::resize(small, bare, channel.size(), 0, 0, cv::INTER_LINEAR);
  return bare;
}

/// How far each pixel is from the paper, 255: as far as can be.
cv::Mat contrastOf(const cv::Mat& channel, const cv::Mat& bare, bool dark_page) {
  cv::Mat contrast(channel.size(), CV_8U);
  for (int y = 0; y < channel.rows; ++y) {
    const auto* value = channel.ptr<std::uint8_t>(y);
    const auto* paper = bare.ptr<std::uint8_t>(y);
    auto* out = contrast.ptr<std::uint8_t>(y);
    for (int x = 0; x < channel.cols; ++x) {
      const int difference = dark_page ? value[x] - paper[x] : paper[x] - value[x];
      const int room = std::max(dark_page ? 255 - paper[x] : +paper[x], 40);
      out[x] = static_cast<std::uint8_t>(std::clamp(255 * difference / room, 0, 255));
    }
  }
  return contrast;
}

std::array<double, 256> histogramOf(const cv::Mat& image) {
  std::array<double, 256> counts{};
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<std::uint8_t>(y);
    for (int x = 0; x < image.cols; ++x) counts[row[x]] += 1.0;
  }
  return counts;
}

/// The value below which `share` of the counts from `first` on lie.
int quantile(const std::array<double, 256>& counts, std::size_t first, double share) {
  double all = 0.0;
  for (std::size_t i = first; i < counts.size(); ++i) all += counts[i];
  double sum = 0.0;
  for (std::size_t i = first; i < counts.size(); ++i) {
    sum += counts[i];
    if (sum >= share * all) return static_cast<int>(i);
  }
  return 255;
}

/// Twice the distance from the middle of a stroke to its border.
double strokeWidth(const cv::Mat& mask) {
  cv::Mat distance;
  cv::distanceTransform(mask, distance, cv::DIST_L2, 3);
  cv::Mat peak;
  cv::dilate(distance, peak, {});
  std::vector<float> widths;
  const auto thickest = static_cast<float>(kThickest / 2.0 * std::max(mask.cols, mask.rows));
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      const float d = distance.at<float>(y, x);
      if (d > 0.0f && d < thickest && d >= peak.at<float>(y, x)) widths.push_back(2.0f * d);
    }
  }
  if (widths.empty()) return 3.0;
  return std::max(1.5, static_cast<double>(medianOf(widths)) - 1.0);
}

void withoutSpecks(cv::Mat& mask, double stroke_px) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(mask, labels, stats, centres, 8);
  const double least = 3.0 * stroke_px * stroke_px;
  std::vector<std::uint8_t> kept(static_cast<std::size_t>(count), 255);
  kept[0] = 0;
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) < least) kept[static_cast<std::size_t>(i)] = 0;
  }
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      mask.at<std::uint8_t>(y, x) = kept[static_cast<std::size_t>(labels.at<int>(y, x))];
    }
  }
}

}  // namespace

int marginOf(const cv::Size& page) {
  return static_cast<int>(kMargin * std::max(page.width, page.height)) + 1;
}

Ink separatedInk(const cv::Mat& page, double least_contrast) {
  cv::Mat grey = page;
  if (page.channels() == 3) cv::cvtColor(page, grey, cv::COLOR_BGR2GRAY);
  Ink ink;
  ink.dark_page = quantile(histogramOf(grey), 0, 0.5) < 100;
  const cv::Mat channel = contrasting(page, ink.dark_page);
  const cv::Mat contrast = contrastOf(channel, barePaper(channel), ink.dark_page);
  const std::array<double, 256> counts = histogramOf(contrast);
  const double noise = 3.0 * quantile(counts, 0, 0.6);  // half of the pixels are at or below 0
  const int faint = static_cast<int>(std::clamp(kNoises * noise, 255.0 * least_contrast, 200.0));
  const int strong = quantile(counts, static_cast<std::size_t>(faint), kStrong);
  cv::threshold(contrast, ink.mask, std::max<double>(faint, kShareOfStrong * strong), 255,
                cv::THRESH_BINARY);
  cv::rectangle(ink.mask, {0, 0}, {page.cols - 1, page.rows - 1}, 0, 2 * marginOf(page.size()));
  ink.stroke_px = strokeWidth(ink.mask);
  if (const cv::Mat strokes = withoutSquares(ink.mask, ink.stroke_px); !strokes.empty()) {
    ink.mask = strokes;
    ink.stroke_px = strokeWidth(ink.mask);
  }
  withoutSpecks(ink.mask, ink.stroke_px);
  ink.any = cv::countNonZero(ink.mask) > kLeastInk * static_cast<double>(page.total());
  return ink;
}

}  // namespace handmap
