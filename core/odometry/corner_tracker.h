// Corners found in an image, and found again in another: Lucas-Kanade on pyramids.
#pragma once

#include <optional>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/odometry/camera_motion.h"

namespace handmap {

/// An image pair made ready for tracking.
struct TrackedPair {
  cv::Mat left;  ///< grey
  std::vector<cv::Mat>
      left_levels;  ///< with derivatives, as cv::buildOpticalFlowPyramid gives them
  std::vector<cv::Mat> right_levels;
};

/// Where points were found; `found[i]` is 0 where point i was not.
struct Tracked {
  std::vector<cv::Point2f> points;
  std::vector<unsigned char> found;
};

/// 8 bit, one or three channels.
TrackedPair preparePair(const cv::Mat& left, const cv::Mat& right);

/// Corners spread over the image: the best few of every cell of a grid.
std::vector<cv::Point2f> findCorners(const cv::Mat& grey);

/// `places` holds where to begin, one for each point.
Tracked track(const std::vector<cv::Mat>& from, const std::vector<cv::Mat>& to,
              const std::vector<cv::Point2f>& points, std::vector<cv::Point2f> places);

/// Where points of the left image are in both; nullopt where the right one does not show them, or
/// they are too far away.
std::vector<std::optional<StereoPixel>> stereoPixels(const TrackedPair& pair,
                                                     const std::vector<cv::Point2f>& points);

/// What looks alike in two left images, wherever it is (ORB): slow, for motions too large to track.
std::vector<StereoMatch> matchFeatures(const TrackedPair& before, const TrackedPair& now);

}  // namespace handmap
