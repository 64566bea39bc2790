#include "core/odometry/corner_tracker.h"

#include <algorithm>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/odometry/constants.h"
#include "core/recording/image_file.h"

namespace handmap {

using namespace odometry;

namespace {

const cv::Size kWindow(kWindow_px, kWindow_px);

}  // namespace

TrackedPair preparePair(const cv::Mat& left, const cv::Mat& right) {
  TrackedPair pair;
  pair.left = greyImage(left);
  cv::buildOpticalFlowPyramid(pair.left, pair.left_levels, kWindow, kLevels, true);
  cv::buildOpticalFlowPyramid(greyImage(right), pair.right_levels, kWindow, kLevels, true);
  return pair;
}

std::vector<cv::Point2f> findCorners(const cv::Mat& grey) {
  std::vector<cv::KeyPoint> corners;
  cv::FAST(grey, corners, kContrast, true);
  std::stable_sort(
      corners.begin(), corners.end(),
      [](const cv::KeyPoint& a, const cv::KeyPoint& b) { return a.response > b.response; });
  std::vector<std::vector<cv::Point2f>> cells(kGridColumns * kGridRows);
  std::vector<cv::Point2f> chosen;
  for (const cv::KeyPoint& corner : corners) {
    const int column = static_cast<int>(corner.pt.x) * kGridColumns / grey.cols;
    const int row = static_cast<int>(corner.pt.y) * kGridRows / grey.rows;
    auto& cell = cells[static_cast<std::size_t>(row * kGridColumns + column)];
    const bool crowded = std::any_of(cell.begin(), cell.end(), [&](const cv::Point2f& other) {
      return cv::norm(other - corner.pt) < kMinDistance_px;
    });
    if (cell.size() == kCornersPerCell || crowded) continue;
    cell.push_back(corner.pt);
    chosen.push_back(corner.pt);
  }
  return chosen;
}

Tracked track(const std::vector<cv::Mat>& from, const std::vector<cv::Mat>& to,
              const std::vector<cv::Point2f>& points, std::vector<cv::Point2f> places) {
  Tracked tracked{std::move(places), {}};
  if (points.empty()) return tracked;
  const cv::TermCriteria until(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kTrackerSteps,
                               kTracked_px);
  cv::calcOpticalFlowPyrLK(from, to, points, tracked.points, tracked.found, cv::noArray(), kWindow,
                           kLevels, until, cv::OPTFLOW_USE_INITIAL_FLOW, kMinEigenvalue);
  return tracked;
}

std::vector<std::optional<StereoPixel>> stereoPixels(const TrackedPair& pair,
                                                     const std::vector<cv::Point2f>& points) {
  const Tracked right = track(pair.left_levels, pair.right_levels, points, points);
  const Tracked back = track(pair.right_levels, pair.left_levels, right.points, right.points);
  std::vector<std::optional<StereoPixel>> pixels(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Point2f& l = points[i];
    const cv::Point2f& r = right.points[i];
    const bool good = right.found[i] != 0 && back.found[i] != 0 &&
                      std::abs(l.y - r.y) < kPixel_px && l.x - r.x > kPixel_px &&
                      cv::norm(back.points[i] - l) < kMaxReturnError_px;
    if (good) pixels[i] = StereoPixel(l.x, l.y, r.x);
  }
  return pixels;
}

std::vector<StereoMatch> matchFeatures(const TrackedPair& before, const TrackedPair& now) {
  const auto orb = cv::ORB::create(kFeatures);
  std::vector<cv::KeyPoint> features_before;
  std::vector<cv::KeyPoint> features_now;
  cv::Mat words_before;
  cv::Mat words_now;
  orb->detectAndCompute(before.left, cv::noArray(), features_before, words_before);
  orb->detectAndCompute(now.left, cv::noArray(), features_now, words_now);
  if (words_before.empty() || words_now.empty()) return {};
  std::vector<cv::DMatch> alike;
  cv::BFMatcher(cv::NORM_HAMMING, true).match(words_before, words_now, alike);
  std::vector<cv::Point2f> points_before;
  std::vector<cv::Point2f> points_now;
  for (const cv::DMatch& match : alike) {
    points_before.push_back(features_before[static_cast<std::size_t>(match.queryIdx)].pt);
    points_now.push_back(features_now[static_cast<std::size_t>(match.trainIdx)].pt);
  }
  const auto pixels_before = stereoPixels(before, points_before);
  const auto pixels_now = stereoPixels(now, points_now);
  std::vector<StereoMatch> matches;
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (pixels_before[i] && pixels_now[i]) matches.push_back({*pixels_before[i], *pixels_now[i]});
  }
  return matches;
}

}  // namespace handmap
