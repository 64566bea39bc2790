// What somebody wrote beside a building, kept in the map as a small picture.
#pragma once

#include <string>

#include <opencv2/core/mat.hpp>

#include "core/map/map.h"

namespace handmap {

/// Member of a building: [width, height, run, run …], the runs from the top left row by row, of
/// paper and ink in turn.
inline constexpr auto kWritingKey = "handmap:writing";

inline constexpr int kWritingWidth_px = 240;
inline constexpr int kWritingHeight_px = 48;

/// Of ink (255), made smaller to fit.
std::string writingText(const cv::Mat& ink);
/// 0 paper, 255 ink; empty: there is none, or the member says something else.
cv::Mat writingOf(const Building& building);

}  // namespace handmap
