// What the windows of an image are known to be.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace handmap {

enum class WindowLabel : std::uint8_t { Unknown, Other, Building };

/// One of each whole window, by the most frequent class among its pixels (of equally frequent ones
/// the lowest number). Windows of the class `ignored` are unknown.
/// `classes`: a class number a pixel, 8 bit.
std::vector<WindowLabel> windowLabels(const cv::Mat1b& classes, int building,
                                      std::optional<int> ignored);

}  // namespace handmap
