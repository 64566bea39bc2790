#include "core/odometry/stereo_odometry.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/phrase.h"
#include "core/odometry/constants.h"

namespace handmap {

using namespace odometry;

namespace {

void check(const cv::Mat& left, const cv::Mat& right, cv::Size size) {
  for (const cv::Mat* image : {&left, &right}) {
    const bool good = !image->empty() && image->depth() == CV_8U &&
                      (image->channels() == 1 || image->channels() == 3) &&
                      (size.empty() || image->size() == size) && image->size() == left.size();
    if (good) continue;
    throwBadInput(phrase("visual odometry"),
                  image == &left ? phrase("left image") : phrase("right image"),
                  phrase("{} × {} pixels, {} channels of {} bits", image->cols, image->rows,
                         image->channels(), 8 * image->elemSize1()),
                  phrase("8 bits, one or three channels, always the same size"));
  }
}

Eigen::Isometry3d spatial(const Pose2& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::AngleAxisd(pose.heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  result.translation() << pose.x, pose.y, 0.0;
  return result;
}

Pose2 planar(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d turn = pose.linear();
  return {pose.translation().x(), pose.translation().y(), std::atan2(turn(1, 0), turn(0, 0))};
}

Pose2 scaled(const Pose2& motion, double factor) {
  return {motion.x * factor, motion.y * factor, motion.heading * factor};
}

}  // namespace

StereoOdometry::StereoOdometry(const StereoCamera& camera, std::uint64_t seed)
    : camera_(camera), seed_(seed) {}

Eigen::Isometry3d StereoOdometry::cameraPose(double pan) const {
  const CameraMount& mount = camera_.mount;
  const double yaw = mount.yaw + pan;
  const double c = std::cos(mount.pitch);
  const double s = std::sin(mount.pitch);
  const Eigen::Vector3d right(std::sin(yaw), -std::cos(yaw), 0.0);
  const Eigen::Vector3d forward(c * std::cos(yaw), c * std::sin(yaw), -s);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() << right, forward.cross(right), forward;
  pose.translation() << mount.x, mount.y, mount.z;
  return pose;
}

void StereoOdometry::makeKey(TrackedPair images, const Eigen::Isometry3d& camera) {
  KeyPair key{std::move(images), camera, pose_, {}, {}};
  const std::vector<cv::Point2f> corners = findCorners(key.images.left);
  const auto pixels = stereoPixels(key.images, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!pixels[i]) continue;
    key.corners.push_back(corners[i]);
    key.pixels.push_back(*pixels[i]);
  }
  // Fog, or a hand before the lens: what was seen before that may be seen again.
  if (!key_ || key.corners.size() >= kMinCorners) key_ = std::move(key);
}

/// Corners of the key pair found in both images now. `guess` moves points from the key camera.
std::vector<StereoMatch> StereoOdometry::matches(const TrackedPair& now,
                                                 const Eigen::Isometry3d& guess) const {
  std::vector<std::size_t> indices;
  std::vector<cv::Point2f> corners;
  std::vector<cv::Point2f> places;
  std::vector<cv::Point2f> disparities;
  for (std::size_t i = 0; i < key_->corners.size(); ++i) {
    const Eigen::Vector3d point = guess * triangulated(camera_, key_->pixels[i]);
    if (point.z() < kNearestKept_m) continue;
    const Eigen::Vector3f place = projected(camera_, point).cast<float>();
    if (!cv::Rect2f(0, 0, static_cast<float>(size_.width), static_cast<float>(size_.height))
             .contains({place.x(), place.y()})) {
      continue;
    }
    indices.push_back(i);
    corners.push_back(key_->corners[i]);
    places.emplace_back(place.x(), place.y());
    disparities.emplace_back(place.x() - place.z(), 0.0F);
  }
  const Tracked left = track(key_->images.left_levels, now.left_levels, corners, places);
  std::vector<cv::Point2f> right_places = left.points;
  for (std::size_t i = 0; i < right_places.size(); ++i) right_places[i] -= disparities[i];
  const Tracked right = track(now.left_levels, now.right_levels, left.points, right_places);
  std::vector<StereoMatch> result;
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const cv::Point2f& l = left.points[i];
    const cv::Point2f& r = right.points[i];
    const bool good = left.found[i] != 0 && right.found[i] != 0 &&
                      std::abs(l.y - r.y) < kPixel_px && l.x - r.x > kPixel_px;
    if (good) result.push_back({key_->pixels[indices[i]], {l.x, l.y, r.x}});
  }
  return result;
}

std::optional<VisualMotion> StereoOdometry::operator()(const cv::Mat& left, const cv::Mat& right,
                                                       double time_s, double pan) {
  check(left, right, size_);
  size_ = left.size();
  TrackedPair now = preparePair(left, right);
  const Eigen::Isometry3d camera = cameraPose(pan);
  const std::uint32_t pair = pairs_++;
  if (!key_) {
    makeKey(std::move(now), camera);
    time_s_ = time_s;
    return std::nullopt;
  }
  const double dt = time_s - time_s_;
  const Pose2 before = pose_;
  const Pose2 predicted = before * scaled(velocity_, dt);
  const Eigen::Isometry3d guess =
      camera.inverse() * spatial(between(key_->pose, predicted)).inverse() * key_->camera;
  VisualMotion result;
  const std::vector<StereoMatch> followed = matches(now, guess);
  result.matches = static_cast<int>(followed.size());
  auto found = estimateMotion(camera_, followed, guess, RandomStream(seed_, pair));
  const double kept =
      found ? static_cast<double>(found->inliers.size()) / static_cast<double>(key_->corners.size())
            : 0.0;
  if (!found) {
    const std::vector<StereoMatch> alike = matchFeatures(key_->images, now);
    const Eigen::Isometry3d still = camera.inverse() * key_->camera;
    found = estimateMotion(camera_, alike, still, RandomStream(seed_, pair, 1), kMinAlike);
    result.matches = static_cast<int>(alike.size());
  }
  result.guessed = !found;
  if (found) {
    result.inliers = static_cast<int>(found->inliers.size());
    pose_ = key_->pose * planar(key_->camera * found->motion.inverse() * camera.inverse());
  } else {
    pose_ = predicted;
  }
  result.motion = between(before, pose_);
  if (found && dt > 0.0) velocity_ = scaled(result.motion, 1.0 / dt);
  time_s_ = time_s;
  if (kept < kKeepKey) makeKey(std::move(now), camera);
  return result;
}

}  // namespace handmap
