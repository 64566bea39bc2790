// Strokes as thin lines: their ends, and the small gaps that a hand leaves at corners.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

/// The ink thinned to lines one pixel wide (Zhang and Suen 1984).
cv::Mat thinned(const cv::Mat& ink);

/// Lines from ends of strokes to the ink that they were meant to meet, at most `reach_px` away: an
/// end, or what lies ahead.
std::vector<std::pair<cv::Point, cv::Point>> bridges(const cv::Mat& thin, double reach_px);

}  // namespace handmap
