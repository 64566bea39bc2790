#include "core/odometry/camera_motion.h"

#include <array>
#include <cmath>
#include <span>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/odometry/constants.h"

namespace handmap {

using namespace odometry;

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

/// A match with its point, in the frame before, and what the point would move by with the pixels
/// that it comes from.
struct Landmark {
  Eigen::Vector3d point;
  Eigen::Matrix3d point_by_pixel;
  StereoPixel now;
};

Eigen::Matrix3d pixelByPoint(const StereoCamera& camera, const Eigen::Vector3d& p) {
  const double x = camera.fx / p.z();
  const double y = camera.fy / p.z();
  Eigen::Matrix3d j;
  j << x, 0.0, -x * p.x() / p.z(),  //
      0.0, y, -y * p.y() / p.z(),   //
      x, 0.0, -x * (p.x() - camera.baseline) / p.z();
  return j;
}

std::vector<Landmark> landmarksOf(const StereoCamera& camera,
                                  const std::vector<StereoMatch>& matches) {
  std::vector<Landmark> landmarks;
  landmarks.reserve(matches.size());
  for (const StereoMatch& match : matches) {
    const Eigen::Vector3d point = triangulated(camera, match.before);
    landmarks.push_back({point, pixelByPoint(camera, point).inverse(), match.now});
  }
  return landmarks;
}

/// One Gauss-Newton step for some landmarks; `use` gives the index of each. Returns the length of
/// the step, negative where it cannot be made.
template <typename Weight>
double improve(const StereoCamera& camera, const std::vector<Landmark>& landmarks,
               std::span<const std::size_t> use, Eigen::Isometry3d& motion, Weight weight_of) {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  for (const std::size_t i : use) {
    const Eigen::Vector3d p = motion * landmarks[i].point;
    if (p.z() < kNearestSeen_m) continue;
    const Eigen::Matrix3d by_point = pixelByPoint(camera, p);
    const StereoPixel residual = landmarks[i].now - projected(camera, p);
    const Eigen::Matrix3d weight = weight_of(landmarks[i], by_point, motion, residual);
    Matrix36d j;
    j.leftCols<3>() = by_point;
    Eigen::Matrix3d turned;
    turned << 0.0, p.z(), -p.y(), -p.z(), 0.0, p.x(), p.y(), -p.x(), 0.0;
    j.rightCols<3>() = by_point * turned;
    const Matrix36d weighted = weight * j;
    normal += j.transpose() * weighted;
    right += weighted.transpose() * residual;
  }
  const Eigen::LDLT<Matrix6d> factors(normal);
  if (factors.info() != Eigen::Success || !factors.isPositive()) return -1.0;
  const Vector6d step = factors.solve(right);
  if (!step.allFinite() || step.norm() > kDiverged) return -1.0;
  const Eigen::Vector3d turn = step.tail<3>();
  Eigen::Isometry3d change = Eigen::Isometry3d::Identity();
  if (turn.norm() > 0.0) {
    change.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  }
  change.translation() = step.head<3>();
  motion = change * motion;
  return step.norm();
}

/// Inverse covariance of a residual: the pixels now and the point from the pixels before; times a
/// Cauchy weight.
Eigen::Matrix3d likelihoodWeight(const Landmark& landmark, const Eigen::Matrix3d& by_point,
                                 const Eigen::Isometry3d& motion, const StereoPixel& residual) {
  const Eigen::Matrix3d j = by_point * motion.linear() * landmark.point_by_pixel;
  const Eigen::Matrix3d covariance =
      kPixelSigma * kPixelSigma * (Eigen::Matrix3d::Identity() + j * j.transpose());
  const Eigen::Matrix3d inverse = covariance.inverse();
  return inverse / (1.0 + residual.dot(inverse * residual) / 3.0);
}

Eigen::Matrix3d noWeight(const Landmark&, const Eigen::Matrix3d&, const Eigen::Isometry3d&,
                         const StereoPixel&) {
  return Eigen::Matrix3d::Identity();
}

std::vector<std::size_t> inliersOf(const StereoCamera& camera,
                                   const std::vector<Landmark>& landmarks,
                                   const Eigen::Isometry3d& motion) {
  std::vector<std::size_t> inliers;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Eigen::Vector3d p = motion * landmarks[i].point;
    if (p.z() < kNearestSeen_m) continue;
    const double error = (landmarks[i].now - projected(camera, p)).squaredNorm();
    if (error < kInlier_px * kInlier_px) inliers.push_back(i);
  }
  return inliers;
}

/// The motion that most landmarks agree with, of many that three of them give each.
CameraMotion consensus(const StereoCamera& camera, const std::vector<Landmark>& landmarks,
                       const Eigen::Isometry3d& guess, RandomStream& random) {
  const int count = static_cast<int>(landmarks.size());
  CameraMotion best{guess, inliersOf(camera, landmarks, guess)};
  for (int hypothesis = 0; hypothesis < kHypotheses; ++hypothesis) {
    std::array<std::size_t, 3> sample{};
    for (std::size_t& index : sample) index = static_cast<std::size_t>(random.index(count));
    if (sample[0] == sample[1] || sample[1] == sample[2] || sample[0] == sample[2]) continue;
    Eigen::Isometry3d motion = guess;
    double step = 1.0;
    for (int i = 0; i < kSampleIterations && step > kSampleConverged; ++i) {
      step = improve(camera, landmarks, sample, motion, noWeight);
    }
    if (step < 0.0) continue;
    std::vector<std::size_t> inliers = inliersOf(camera, landmarks, motion);
    if (inliers.size() > best.inliers.size()) best = {motion, std::move(inliers)};
  }
  return best;
}

}  // namespace

Eigen::Vector3d triangulated(const StereoCamera& camera, const StereoPixel& pixel) {
  const double z = camera.fx * camera.baseline / (pixel.x() - pixel.z());
  return {(pixel.x() - camera.cx) / camera.fx * z, (pixel.y() - camera.cy) / camera.fy * z, z};
}

StereoPixel projected(const StereoCamera& camera, const Eigen::Vector3d& point) {
  const double u = camera.fx * point.x() / point.z() + camera.cx;
  return {u, camera.fy * point.y() / point.z() + camera.cy,
          u - camera.fx * camera.baseline / point.z()};
}

std::optional<CameraMotion> estimateMotion(const StereoCamera& camera,
                                           const std::vector<StereoMatch>& matches,
                                           const Eigen::Isometry3d& guess, RandomStream random,
                                           double min_share) {
  if (matches.size() < kMinInliers) return std::nullopt;
  const std::vector<Landmark> landmarks = landmarksOf(camera, matches);
  CameraMotion best = consensus(camera, landmarks, guess, random);
  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    double step = 1.0;
    for (int i = 0; i < kIterations && step > kConverged; ++i) {
      step = improve(camera, landmarks, best.inliers, best.motion, likelihoodWeight);
    }
    if (step < 0.0) return std::nullopt;
    best.inliers = inliersOf(camera, landmarks, best.motion);
  }
  const double share =
      static_cast<double>(best.inliers.size()) / static_cast<double>(matches.size());
  if (best.inliers.size() < kMinInliers || share < min_share) return std::nullopt;
  return best;
}

}  // namespace handmap
