#include "core/perception/ground_plane.h"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace handmap {
namespace {

constexpr int kStep = 3;  ///< every third pixel of every third row
// Where the ground is taken for a plane: beyond the robot itself, and as far as streets are flat.
constexpr double kNearest_m = 2.0;
constexpr double kFarthest_m = 20.0;
constexpr double kAside_m = 10.0;
// Half widths of the Tukey weight, metres: from what the mount may be wrong to what a road is.
constexpr double kWidths_m[] = {0.6, 0.4, 0.3, 0.2, 0.2};
// How well the mount tells the ground, 1 σ; it counts as that many pixels, which err together.
constexpr double kPriorHeight_m = 0.05;
constexpr double kPriorSlope = 0.02;
constexpr double kPriorPixels = 100.0;
constexpr double kPixelSigma_m = 0.05;  ///< of the height of a pixel of the road at some 10 m

std::vector<Eigen::Vector3d> lowPoints(const cv::Mat1f& disparity, const StereoCamera& camera,
                                       const CameraRays& rays) {
  std::vector<Eigen::Vector3d> points;
  const double depth_disparity = camera.fx * camera.baseline;
  for (int row = 0; row < disparity.rows; row += kStep) {
    const auto r = static_cast<std::size_t>(row);
    if (rays.up[r] >= 0.0) continue;
    const float* line = disparity[row];
    for (int column = 0; column < disparity.cols; column += kStep) {
      if (!(line[column] > 0.0F)) continue;
      const double depth = depth_disparity / static_cast<double>(line[column]);
      const Eigen::Vector3d p(depth * rays.forward[r],
                              depth * rays.left[static_cast<std::size_t>(column)],
                              camera.mount.z + depth * rays.up[r]);
      if (p.x() > kNearest_m && p.x() < kFarthest_m && std::abs(p.y()) < kAside_m &&
          std::abs(p.z()) < 2.0 * kWidths_m[0]) {
        points.push_back(p);
      }
    }
  }
  return points;
}

}  // namespace

GroundPlane fitGround(const cv::Mat1f& disparity, const StereoCamera& camera,
                      const CameraRays& rays) {
  const std::vector<Eigen::Vector3d> points = lowPoints(disparity, camera, rays);
  const double pixel_information = 1.0 / (kPixelSigma_m * kPixelSigma_m);
  const Eigen::Vector3d prior =
      kPriorPixels * Eigen::Vector3d(1.0 / (kPriorHeight_m * kPriorHeight_m),
                                     1.0 / (kPriorSlope * kPriorSlope),
                                     1.0 / (kPriorSlope * kPriorSlope));
  GroundPlane plane;
  for (const double width : kWidths_m) {
    Eigen::Matrix3d normal = prior.asDiagonal();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& p : points) {
      const double ratio = (p.z() - plane.at(p.x(), p.y())) / width;
      if (std::abs(ratio) >= 1.0) continue;
      const double tukey = (1.0 - ratio * ratio) * (1.0 - ratio * ratio);
      const Eigen::Vector3d row(1.0, p.x(), p.y());
      const double weight = pixel_information * tukey;
      normal += weight * row * row.transpose();
      right += weight * p.z() * row;
    }
    const Eigen::Vector3d solution = normal.ldlt().solve(right);
    plane = {solution.x(), solution.y(), solution.z()};
  }
  return plane;
}

}  // namespace handmap
