// Edges of every window: how many, in which directions, and how well they line up.
#pragma once

#include <array>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/classification/windows.h"

namespace handmap {

inline constexpr int kEdgeDirections = 8;

/// Of one window. An edge pixel is one with a brightness gradient of at least 24 grey levels over
/// two pixels.
struct EdgeStatistics {
  float density = 0.0F;  ///< share of edge pixels
  /// Most votes for one straight line two pixels wide, over two sides: 1 is a step right across
  /// the window. Each edge pixel votes once, for the line along its own direction (O'Gorman and
  /// Clowes 1976).
  float hough_peak = 0.0F;
  /// Circular variance of the edge directions modulo 180°: 0 all parallel, 1 no direction; 1
  /// where there are no edges.
  float direction_variance = 1.0F;
  float strength = 0.0F;  ///< mean gradient of all pixels, over 255
  float contrast = 0.0F;  ///< standard deviation of the brightness, over 255
  /// Share of edge pixels whose gradient points along each of the directions modulo 180°; the
  /// first is centred on horizontal gradients (upright edges). Zero where there are no edges.
  std::array<float, kEdgeDirections> directions{};
};

/// One of each window of a grey 8-bit image.
std::vector<EdgeStatistics> edgeStatistics(const cv::Mat1b& grey);

}  // namespace handmap
