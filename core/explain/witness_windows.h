// Where in an image the looks lie that placed a wall.
#pragma once

#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/explain/wall_story.h"
#include "core/recording/camera.h"

namespace handmap {

/// The windows (see StereoResult::buildings) of a witness's left image that its returns fall in:
/// from where the wall stands on the ground up as far as they are judged to show a building, or,
/// where nothing was judged, three metres up. `pan`: of the camera then, radians. Each once, by row
/// and column, clipped to an image of `size`; empty where the camera looked elsewhere.
std::vector<cv::Rect> windowsOf(const WallWitness& witness, const StereoCamera& camera, double pan,
                                const cv::Mat1f& buildings, cv::Size size);

}  // namespace handmap
