// What may be a building: closed outlines, also those that writing or small gaps break.
#pragma once

#include "core/paper/ink.h"
#include "core/paper/regions.h"

namespace handmap {

struct Candidate {
  Region region;
  double inked = 1.0;    ///< share of the outline that lies on ink; the rest are bridged gaps
  double covered = 0.0;  ///< share of the outline that is the edge of what lies on the page
};

/// Sizes of what a hand draws on a page, pixels.
struct PageScale {
  explicit PageScale(const Ink& ink);

  double stroke_px;
  double least_px;   ///< thickness of the smallest thing that is no letter
  double gap_px;     ///< the largest gap that still counts as closed
  double letter_px;  ///< the largest sign of handwriting
  double sign_px;    ///< the usual sign of the handwriting; 0: there is none
  double road_px;    ///< the widest road, as those who draw both sides of one leave between them
};

/// `cover`: 255 where something lies over the page; or empty.
std::vector<Candidate> candidatesOf(const Ink& ink, const PageScale& scale,
                                    const cv::Mat& cover = {});

}  // namespace handmap
