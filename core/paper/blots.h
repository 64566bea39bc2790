// Ink that is no stroke: buildings filled with ink, and what lies on the page.
#pragma once

#include <vector>

#include "core/paper/ink.h"
#include "core/paper/regions.h"

namespace handmap {

struct PageScale;

struct Blots {
  std::vector<Region> filled;  ///< whole on the page
  cv::Mat foreign;             ///< 255: a hand, a sleeve, a pen, which come from beyond the page
};

/// What lies over a page of white paper and reaches its edge, 255: broad, and of another colour
/// than the paper or darker than it is in a shadow. A white sleeve is paper.
cv::Mat coverOf(const cv::Mat& page);

Blots blotsOf(const Ink& ink, const PageScale& scale);

}  // namespace handmap
