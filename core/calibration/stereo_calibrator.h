// From a checkerboard seen by both cameras to the calibration of a stereo camera.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/board_images.h"
#include "core/recording/stereo_calibration.h"

namespace handmap {

inline constexpr std::size_t kLeastPairs = 6;

struct UsedPair {
  std::string name;
  double error_px = 0.0;  ///< root mean square of both images
};

struct CalibrationResult {
  StereoCalibration calibration;
  double left_error_px = 0.0;  ///< of reprojection, root mean square
  double right_error_px = 0.0;
  double epipolar_error_px = 0.0;  ///< rows of a corner in the rectified images, mean difference
  double focal_sigma = 0.0;        ///< of the left camera, relative
  double board_turn = 0.0;         ///< radians: the most that two boards are turned to each other
  std::vector<UsedPair> used;
  std::vector<RefusedPair> refused;  ///< those that had been, and those that do not fit the others
};

/// Each camera alone, then both together (cv::stereoCalibrate, distortion k1 k2 p1 p2). Throws
/// BadInput where the result would be nonsense: too few pairs, boards all turned the same way, an
/// error too large, left and right swapped. `source` names the images in messages.
CalibrationResult calibrateStereo(BoardImages images, const Board& board,
                                  const std::string& source);

/// JSON: pairs used and refused, and the figures of the result.
std::string calibrationReportJson(const CalibrationResult& result, const Board& board);

}  // namespace handmap
