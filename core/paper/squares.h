// Squared paper whose lines are as dark as the pencil.
#pragma once

#include <opencv2/core/mat.hpp>

namespace handmap {

/// The ink without the lines of printed squares, where they fill a page; strokes across them and
/// thicker ones along them stay. Of squares that are no regular grid (a page that is crumpled)
/// nothing is left: what was drawn cannot be told from them. Empty: there are none.
cv::Mat withoutSquares(const cv::Mat& ink, double stroke_px);

}  // namespace handmap
