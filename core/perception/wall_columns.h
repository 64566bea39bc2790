// Walls in a disparity image: per image column the vertical extent over disparity.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/perception/ground_plane.h"
#include "core/perception/wall_points.h"
#include "core/recording/observation.h"

namespace handmap {

/// A wall seen in one image column, in the levelled frame of the camera.
struct WallColumn {
  double x;          ///< metres forward
  double y;          ///< metres to the left
  double extent_m;   ///< vertical metres seen of it above the filter's min_height
  int column = 0;    ///< of the image
  double row = 0.0;  ///< the mean of the rows that show that
  double half_rows = 0.0;
  double building = 1.0;  ///< probability that it is of a building
};

/// A vertical wall has one forward distance in a whole column: it stands out of a histogram over
/// disparity in which every pixel counts with the vertical metres it covers. Columns from left to
/// right, near walls first.
std::vector<WallColumn> wallColumns(const cv::Mat1f& disparity, const StereoCamera& camera,
                                    const CameraRays& rays, const GroundPlane& ground,
                                    const WallFilter& filter, double max_range_m);

}  // namespace handmap
