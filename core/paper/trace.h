// From a photo of a drawing to the outlines of its buildings.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/paper/candidates.h"
#include "core/paper/page.h"

namespace handmap {

/// Below it a shape is shown but not taken without a person.
inline constexpr double kSureOfShape = 0.5;

/// A closed shape of the drawing.
struct TracedShape {
  Polygon outline;  ///< pixels of the page, x right, y up from its lower left corner
  std::optional<Rectangle> rectangle;  ///< the outline, where it is one
  double confidence = 0.0;             ///< 0 … 1, that it is a building
  double misfit = 0.0;                 ///< of the ink to the outline, rms, a share of its diagonal
  cv::Rect box;                        ///< on the page, y down: the crop with its ink
  cv::Mat ink;                         ///< within the box: what it was drawn with
  std::optional<cv::Rect> writing;     ///< on the page, y down: handwriting in the shape
};

/// The longer side that photos are reduced to before the page is looked for.
inline constexpr int kPhotoSide_px = 2 * kPageSide_px;

struct Trace {
  Page page;
  Ink ink;
  bool covered = false;             ///< of a sheet: a hand lies over it
  std::vector<TracedShape> shapes;  ///< from left to right
};

/// Of a photo or scan of any size; of one of some pixels there is no page.
Trace traced(const cv::Mat& photo);
/// Of a page that is straightened already.
Trace traced(Page page);
/// Why a page without shapes may have none, to be said to a person; empty where nothing is wrong
/// with the photo.
std::string troubleWith(const cv::Mat& photo);

/// As pixels of the photo, y down.
std::vector<cv::Point2d> onPhoto(const Polygon& outline, const Page& page);

}  // namespace handmap
