#include "core/perception/ground_plane.h"

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

std::vector<Eigen::Vector3d> lowPoints(const cv::Mat1f& disparity, const StereoCamera& camera,
                                       const CameraRays& rays) {
  std::vector<Eigen::Vector3d> points;
  const double depth_disparity = camera.fx * camera.baseline;
  for (int row = 0; row < disparity.rows; row += kGroundStep_px) {
    const auto r = static_cast<std::size_t>(row);
    if (rays.up[r] >= 0.0) continue;
    const float* line = disparity[row];
    for (int column = 0; column < disparity.cols; column += kGroundStep_px) {
      if (!(line[column] > 0.0F)) continue;
      const double depth = depth_disparity / static_cast<double>(line[column]);
      const Eigen::Vector3d p(depth * rays.forward[r],
                              depth * rays.left[static_cast<std::size_t>(column)],
                              camera.mount.z + depth * rays.up[r]);
      if (p.x() > kGroundNearest_m && p.x() < kGroundFarthest_m &&
          std::abs(p.y()) < kGroundAside_m && std::abs(p.z()) < 2.0 * kGroundWidths_m[0]) {
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
  const double pixel_information = 1.0 / (kGroundSigma_m * kGroundSigma_m);
  const Eigen::Vector3d prior =
      kPriorPixels * Eigen::Vector3d(1.0 / (kGroundSigma_m * kGroundSigma_m),
                                     1.0 / (kGroundSlope * kGroundSlope),
                                     1.0 / (kGroundSlope * kGroundSlope));
  GroundPlane plane;
  for (const double width : kGroundWidths_m) {
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
