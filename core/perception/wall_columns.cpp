#include "core/perception/wall_columns.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

struct Bin {
  float metres = 0.0F;  ///< vertical; the weight of the rest
  float level = 0.0F;   ///< sum of metres × level
  float depth = 0.0F;   ///< sum of metres × depth per metre forward
  float row = 0.0F;     ///< sum of metres × row
  float rows = 0.0F;    ///< pixels
};

/// Vertical metres over disparity, for every image column.
class Histogram {
 public:
  Histogram(int columns, double max_level)
      : bins_(static_cast<int>(max_level * kBinsPerPixel) + 1),
        cells_(static_cast<std::size_t>(bins_ * columns)) {}

  int bins() const { return bins_; }
  void add(int column, int row, double level, double depth, double metres) {
    Bin& bin = cells_[index(column, static_cast<int>(level * kBinsPerPixel))];
    bin.metres += static_cast<float>(metres);
    bin.level += static_cast<float>(metres * level);
    bin.depth += static_cast<float>(metres * depth);
    bin.row += static_cast<float>(metres * row);
    bin.rows += 1.0F;
  }
  Bin windowSum(int column, int bin) const {
    Bin sum;
    for (int i = std::max(0, bin - kReach); i <= std::min(bins_ - 1, bin + kReach); ++i) {
      const Bin& cell = cells_[index(column, i)];
      sum.metres += cell.metres;
      sum.level += cell.level;
      sum.depth += cell.depth;
      sum.row += cell.row;
      sum.rows += cell.rows;
    }
    return sum;
  }

 private:
  std::size_t index(int column, int bin) const {
    return static_cast<std::size_t>(column * bins_ + bin);
  }

  int bins_;
  std::vector<Bin> cells_;
};

/// Disparities between which a wall may be. A level is the disparity that a point would have if the
/// camera were not pitched: the same for all heights of a vertical wall.
struct Levels {
  double least;
  double most;
};

Levels levelsOf(const cv::Mat1f& disparity, double depth_disparity, const CameraRays& rays,
                double min_range_m, double max_range_m) {
  double largest = 0.0;
  cv::minMaxLoc(disparity, nullptr, &largest);
  const double shortest =
      std::max(0.25, *std::min_element(rays.forward.begin(), rays.forward.end()));
  return {depth_disparity / max_range_m,
          std::min(std::max(0.0, largest) / shortest, depth_disparity / min_range_m)};
}

/// No pixel of a row can be that high: along a ray the height above the ground is linear in x.
bool staysBelow(double min_height_m, double rise, double forward, double max_x_m,
                const StereoCamera& camera, const CameraRays& rays, const GroundPlane& ground) {
  const double aside = std::max(std::abs(rays.left.front()), std::abs(rays.left.back())) / forward;
  const double at_camera = camera.mount.z - ground.height;
  const double along_x = rise - ground.slope_x + std::abs(ground.slope_y) * aside;
  return at_camera + std::max(0.0, along_x * max_x_m) < min_height_m;
}

void fill(Histogram& histogram, const cv::Mat1f& disparity, const StereoCamera& camera,
          const CameraRays& rays, const GroundPlane& ground, const WallFilter& filter,
          const Levels& levels) {
  const double depth_disparity = camera.fx * camera.baseline;
  for (int row = 0; row + 1 < disparity.rows; ++row) {
    const auto r = static_cast<std::size_t>(row);
    const double forward = rays.forward[r];
    const double next_forward = rays.forward[r + 1];
    if (forward <= 0.0 || next_forward <= 0.0) continue;
    const double rise = rays.up[r] / forward;
    const double pixel_rise = rise - rays.up[r + 1] / next_forward;
    if (staysBelow(filter.min_height_m, rise, forward, depth_disparity / levels.least, camera, rays,
                   ground)) {
      continue;
    }
    const float* line = disparity[row];
    for (int column = 0; column < disparity.cols; ++column) {
      const double level = static_cast<double>(line[column]) / forward;
      if (!(level >= levels.least && level <= levels.most)) continue;
      const double x = depth_disparity / level;
      const double y = x / forward * rays.left[static_cast<std::size_t>(column)];
      const double height = camera.mount.z + x * rise - ground.at(x, y);
      if (height < filter.min_height_m || height > filter.max_height_m) continue;
      histogram.add(column, row, level, 1.0 / forward, x * pixel_rise);
    }
  }
}

}  // namespace

std::vector<WallColumn> wallColumns(const cv::Mat1f& disparity, const StereoCamera& camera,
                                    const CameraRays& rays, const GroundPlane& ground,
                                    const WallFilter& filter, double max_range_m) {
  const double depth_disparity = camera.fx * camera.baseline;
  const Levels levels = levelsOf(disparity, depth_disparity, rays, filter.min_range_m, max_range_m);
  Histogram histogram(disparity.cols, levels.most);
  fill(histogram, disparity, camera, rays, ground, filter, levels);

  std::vector<WallColumn> walls;
  std::vector<Bin> sums(static_cast<std::size_t>(histogram.bins()));
  for (int column = 0; column < disparity.cols; ++column) {
    for (int bin = 0; bin < histogram.bins(); ++bin) {
      sums[static_cast<std::size_t>(bin)] = histogram.windowSum(column, bin);
    }
    // A peak is higher than everything whose window meets its own; the nearer of equals.
    const auto less = [](const Bin& a, const Bin& b) { return a.metres < b.metres; };
    for (auto peak = sums.rbegin(); peak != sums.rend(); ++peak) {
      if (peak->metres < static_cast<float>(filter.min_extent_m)) continue;
      const auto nearer = peak - std::min<std::ptrdiff_t>(2 * kReach, peak - sums.rbegin());
      const auto farther = peak + std::min<std::ptrdiff_t>(2 * kReach, sums.rend() - peak - 1);
      if (std::max_element(nearer, farther + 1, less) != peak) continue;
      const auto extent = static_cast<double>(peak->metres);
      const double x = depth_disparity * extent / static_cast<double>(peak->level);
      const double depth = x * static_cast<double>(peak->depth) / extent;
      walls.push_back({x, depth * rays.left[static_cast<std::size_t>(column)], extent, column,
                       static_cast<double>(peak->row) / extent,
                       static_cast<double>(peak->rows) / 2.0});
    }
  }
  return walls;
}

}  // namespace handmap
