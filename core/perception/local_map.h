// The robot-centred grid of votes for walls (paper, II-B).
#pragma once

#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/lazy.h"
#include "core/perception/constants.h"
#include "core/perception/wall_points.h"
#include "core/recording/observation.h"

namespace handmap {

/// Square grid in the robot frame, robot at the centre; row = y, column = x; values 0 … 1.
class LocalMap {
 public:
  LocalMap(double cell_m, double range_m);

  double cell() const { return cell_; }
  double range() const { return range_; }  ///< half the side, metres
  const cv::Mat1f& cells() const { return cells_; }
  cv::Mat1f& cells() { return cells_; }
  int columnOf(double x) const { return static_cast<int>(std::floor((x + range_) / cell_)); }
  /// Value of the cell around a point of the robot frame; 0 outside the grid.
  float at(double x, double y) const {
    const int column = columnOf(x);
    const int row = columnOf(y);
    if (column < 0 || row < 0 || column >= cells_.cols || row >= cells_.rows) return 0.0F;
    return cells_(row, column);
  }

 private:
  double cell_;
  double range_;
  cv::Mat1f cells_;
};

struct LocalMapOptions {
  double cell_m = perception::kMapCell_m;
  double smoothing_sigma_m =
      perception::kSmoothing_m;  ///< Gaussian; so wide as the noise of near points
  double saturation_votes =
      perception::kSaturation;  ///< a cell with this many votes is as sure as can be
  double path_m =
      perception::kPath_m;  ///< a moving robot's map holds the points of its last metres
};

/// A local map that is rendered when somebody reads it.
class LazyLocalMap {
 public:
  LazyLocalMap() = default;  ///< none
  LazyLocalMap(double range_m, std::function<LocalMap()> render)
      : range_m_(range_m), map_(std::move(render)) {}

  explicit operator bool() const { return static_cast<bool>(map_); }
  double range() const { return range_m_; }  ///< of the map; renders nothing
  const LocalMap& get() const { return map_.get(); }
  operator const LocalMap&() const { return get(); }  // NOLINT(google-explicit-constructor)
  /// See Lazy::again().
  LazyLocalMap again() const {
    LazyLocalMap other = *this;
    other.map_ = map_.again();
    return other;
  }
  bool operator==(const LazyLocalMap&) const = default;

 private:
  double range_m_ = 0.0;
  Lazy<LocalMap> map_;
};

/// Collects wall points. A standing robot's map holds the points of that stop alone; a moving
/// robot's those of its last metres, placed by odometry.
class LocalMapBuilder {
 public:
  LocalMapBuilder(double range_m, const LocalMapOptions& options);

  /// `walls` in the robot frame at `odometry`.
  LazyLocalMap add(const Pose2& odometry, bool standing, std::vector<WallPoint> walls);

 private:
  struct Scan {
    Pose2 odometry;
    double travelled_m;
    std::shared_ptr<const std::vector<WallPoint>> walls;
  };
  static LocalMap render(double range_m, const LocalMapOptions& options,
                         const std::vector<Scan>& scans);

  double range_;
  LocalMapOptions options_;
  std::deque<Scan> scans_;
};

}  // namespace handmap
