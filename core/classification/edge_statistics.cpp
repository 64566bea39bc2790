#include "core/classification/edge_statistics.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>

#include <opencv2/core.hpp>

namespace handmap {

namespace {

constexpr int kEdgeGradient = 24;
constexpr int kAngles = 2 * kEdgeDirections;  // of the lines, over 180°
constexpr int kOffsets = 24;                  // of the lines: a window's diagonal, a pixel each
constexpr int kTableSide = 128;               // gradients in steps of 4 levels

/// What depends on an angle alone.
struct Angles {
  std::array<std::uint8_t, kTableSide * kTableSide> of_gradient{};
  std::array<std::int16_t, kAngles> cosine{};  // times 256
  std::array<std::int16_t, kAngles> sine{};
  std::array<float, kAngles> double_cosine{};
  std::array<float, kAngles> double_sine{};
};

Angles makeAngles() {
  constexpr double kPi = std::numbers::pi;
  Angles angles;
  for (int y = 0; y < kTableSide; ++y) {
    for (int x = 0; x < kTableSide; ++x) {
      const double angle = std::atan2(y - kTableSide / 2, x - kTableSide / 2);
      const auto index = static_cast<int>(std::lround(angle / kPi * kAngles)) + 2 * kAngles;
      angles.of_gradient[static_cast<std::size_t>(y * kTableSide + x)] =
          static_cast<std::uint8_t>(index % kAngles);
    }
  }
  for (std::size_t i = 0; i < kAngles; ++i) {
    const double angle = static_cast<double>(i) * kPi / kAngles;
    angles.cosine[i] = static_cast<std::int16_t>(std::lround(256.0 * std::cos(angle)));
    angles.sine[i] = static_cast<std::int16_t>(std::lround(256.0 * std::sin(angle)));
    angles.double_cosine[i] = static_cast<float>(std::cos(2.0 * angle));
    angles.double_sine[i] = static_cast<float>(std::sin(2.0 * angle));
  }
  return angles;
}

/// Sums over one window.
struct Sums {
  int edges = 0;
  int gradient = 0;
  int brightness = 0;
  int squares = 0;
  std::array<std::uint16_t, kAngles> angles{};
  std::array<std::array<std::uint8_t, kOffsets>, kAngles> lines{};
};

/// One row of a window: plain sums in one pass, then its edge pixels one by one.
void addRow(const std::uint8_t* above, const std::uint8_t* here, const std::uint8_t* below, int y,
            const Angles& angles, Sums& sums) {
  std::array<std::int16_t, kWindow_px> dx;
  std::array<std::int16_t, kWindow_px> dy;
  std::array<std::uint8_t, kWindow_px> edge;
  int gradient = 0;
  int brightness = 0;
  int squares = 0;
  for (std::size_t x = 0; x < kWindow_px; ++x) {
    dx[x] = static_cast<std::int16_t>(here[x + 1] - (here - 1)[x]);
    dy[x] = static_cast<std::int16_t>(below[x] - above[x]);
    // The length of the gradient within 4 % (greater plus ⅜ of the smaller).
    const int a = std::abs(dx[x]);
    const int b = std::abs(dy[x]);
    const int length = std::max(a, b) + 3 * std::min(a, b) / 8;
    edge[x] = length >= kEdgeGradient ? 1 : 0;
    gradient += length;
    brightness += here[x];
    squares += here[x] * here[x];
  }
  sums.gradient += gradient;
  sums.brightness += brightness;
  sums.squares += squares;
  for (std::size_t x = 0; x < kWindow_px; ++x) {
    if (edge[x] == 0) continue;
    const int place = (dy[x] / 4 + kTableSide / 2) * kTableSide + dx[x] / 4 + kTableSide / 2;
    const std::size_t angle = angles.of_gradient[static_cast<std::size_t>(place)];
    const int offset = (2 * static_cast<int>(x) - kWindow_px + 1) * angles.cosine[angle] +
                       (2 * y - kWindow_px + 1) * angles.sine[angle];
    ++sums.edges;
    ++sums.angles[angle];
    ++sums.lines[angle][static_cast<std::size_t>((offset + kOffsets * 256) / 512)];
  }
}

EdgeStatistics statisticsOf(const Sums& sums, const Angles& angles) {
  constexpr float kPixels = kWindow_px * kWindow_px;
  EdgeStatistics result;
  const float mean = static_cast<float>(sums.brightness) / kPixels;
  const float variance = static_cast<float>(sums.squares) / kPixels - mean * mean;
  result.contrast = std::sqrt(std::max(variance, 0.0F)) / 255.0F;
  result.strength = static_cast<float>(sums.gradient) / kPixels / 255.0F;
  if (sums.edges == 0) return result;
  const auto edges = static_cast<float>(sums.edges);
  result.density = edges / kPixels;
  int peak = 0;
  float cosine = 0.0F;
  float sine = 0.0F;
  for (std::size_t i = 0; i < kAngles; ++i) {
    const auto votes = static_cast<float>(sums.angles[i]);
    cosine += votes * angles.double_cosine[i];
    sine += votes * angles.double_sine[i];
    // A direction takes its own angle and half of the two between it and its neighbours.
    if (i % 2 == 0) {
      result.directions[i / 2] += votes / edges;
    } else {
      result.directions[i / 2] += 0.5F * votes / edges;
      result.directions[(i / 2 + 1) % kEdgeDirections] += 0.5F * votes / edges;
    }
    for (std::size_t k = 1; k < kOffsets; ++k) {
      peak = std::max(peak, sums.lines[i][k - 1] + sums.lines[i][k]);
    }
  }
  result.hough_peak = static_cast<float>(peak) / (2 * kWindow_px);
  result.direction_variance = 1.0F - std::sqrt(cosine * cosine + sine * sine) / edges;
  return result;
}

}  // namespace

std::vector<EdgeStatistics> edgeStatistics(const cv::Mat1b& grey) {
  static const Angles kTable = makeAngles();
  const WindowGrid grid = WindowGrid::of(grey.size());
  cv::Mat1b framed;
  cv::copyMakeBorder(grey, framed, 1, 1, 1, 1, cv::BORDER_REPLICATE);
  std::vector<EdgeStatistics> result;
  result.reserve(static_cast<std::size_t>(grid.count()));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      Sums sums;
      for (int y = 0; y < kWindow_px; ++y) {
        const int line = row * kWindow_px + y;
        const int from = column * kWindow_px + 1;
        addRow(framed[line] + from, framed[line + 1] + from, framed[line + 2] + from, y, kTable,
               sums);
      }
      result.push_back(statisticsOf(sums, kTable));
    }
  }
  return result;
}

}  // namespace handmap
