// The page on a photo: found, straightened, seen from above.
#pragma once

#include <optional>

#include <opencv2/core/mat.hpp>

#include "core/paper/quad.h"
#include "core/paper/sheet.h"

namespace handmap {

/// The longer side of a straightened page: a pen of 0.5 mm on A4 is three pixels wide then.
inline constexpr int kPageSide_px = 1800;

struct Page {
  cv::Mat image;                                ///< 8 bit, three channels
  cv::Matx33d from_photo = cv::Matx33d::eye();  ///< pixels of the photo to those of the page
  bool edges_found = false;                     ///< else the photo is taken to be the page
  std::optional<SheetCode> sheet;               ///< of a printed sheet: the page is its grid
};

/// The outline of a page that differs from the table it lies on; nullopt where none is seen, also
/// where the page is larger than the photo.
std::optional<Quad> pageOutline(const cv::Mat& photo);

/// Width over height of the rectangle that a camera sees as this quad.
double aspectOf(const Quad& quad, const cv::Size& photo);

/// The part of the photo within the quad, its longer side at most kPageSide_px. `aspect`: width
/// over height of the page.
Page straightened(const cv::Mat& photo, const Quad& quad, double aspect);

/// With the sheet or the page found, or the whole photo.
Page pageOf(const cv::Mat& photo);

}  // namespace handmap
