#include "core/trajectory/scan_features.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include <Eigen/Eigenvalues>

#include "core/base/median.h"
#include "core/geometry/to_outer.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

/// Sums of a few points, for the line through them.
class LineSums {
 public:
  void add(const Vec2& p) {
    ++count_;
    sum_ += p;
    squares_ += p * p.transpose();
  }
  void add(const LineSums& other) {
    count_ += other.count_;
    sum_ += other.sum_;
    squares_ += other.squares_;
  }

  /// A point with the normal towards the origin where the points make a straight piece, else zero.
  ScanPoint feature(const Vec2& at) const {
    if (count_ < kLeastPoints) return {at, Vec2::Zero(), 1.0};
    const Vec2 mean = sum_ / count_;
    const Eigen::Matrix2d scatter = squares_ - mean * sum_.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(scatter / (count_ - 2));
    const double thickness = std::sqrt(std::max(axes.eigenvalues()(0), 0.0));
    const double length = std::sqrt(12.0 * axes.eigenvalues()(1));
    if (thickness > kRough_m + kRoughPerMetre * mean.norm()) return {at};
    if (length < kLeastLength * thickness) return {at};
    const Vec2 normal = axes.eigenvectors().col(0);
    const double slope = axes.eigenvalues()(0) / axes.eigenvalues()(1);
    return {at, normal.dot(mean) > 0.0 ? Vec2(-normal) : normal, std::max(0.0, slope) / count_};
  }

 private:
  int count_ = 0;
  Vec2 sum_ = Vec2::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
};

struct Polar {
  double bearing;
  Vec2 at;
};

/// The usual angle between two returns.
double spacing(const std::vector<Polar>& points) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps.push_back(points[i].bearing - points[i - 1].bearing);
  }
  return medianOf(std::move(steps));
}

std::uint64_t cellOf(const Vec2& at, double cell_m) {
  const auto index = [&](double v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v / cell_m)));
  };
  return (static_cast<std::uint64_t>(index(at.x())) << 32U) | index(at.y());
}

}  // namespace

std::vector<ScanPoint> planarFeatures(const std::vector<RangePoint>& points) {
  std::vector<Polar> scan;
  scan.reserve(points.size());
  for (const RangePoint& p : points) {
    const Vec2 at(p.x, p.y);
    scan.push_back({std::atan2(at.y(), at.x()), at});
  }
  std::stable_sort(scan.begin(), scan.end(),
                   [](const Polar& a, const Polar& b) { return a.bearing < b.bearing; });
  const double step = spacing(scan);
  const auto gap = [&](std::size_t a, std::size_t b) {
    const double range = std::min(scan[a].at.norm(), scan[b].at.norm());
    return (scan[a].at - scan[b].at).norm() > std::max(kNear_m, kGapSpacings * step * range);
  };
  std::vector<ScanPoint> features(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    LineSums sums;
    sums.add(scan[i].at);
    for (std::size_t j = i; j > 0 && i - j < kNeighbours && !gap(j, j - 1); --j) {
      sums.add(scan[j - 1].at);
    }
    for (std::size_t j = i + 1; j < scan.size() && j - i <= kNeighbours && !gap(j - 1, j); ++j) {
      sums.add(scan[j].at);
    }
    features[i] = sums.feature(scan[i].at);
  }
  return features;
}

std::vector<ScanPoint> standingFeatures(const std::vector<Vec2>& points) {
  struct Cell {
    LineSums sums;
    Vec2 first;
  };
  std::unordered_map<std::uint64_t, std::size_t> index;
  std::vector<Cell> cells;
  for (const Vec2& p : points) {
    const auto [found, fresh] = index.emplace(cellOf(p, kStandingCell_m), cells.size());
    if (fresh) cells.push_back({{}, p});
    cells[found->second].sums.add(p);
  }
  std::vector<ScanPoint> features;
  features.reserve(cells.size());
  for (const Cell& cell : cells) {
    LineSums around;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const Vec2 at = cell.first + kStandingCell_m * Vec2(dx, dy);
        const auto found = index.find(cellOf(at, kStandingCell_m));
        if (found != index.end()) around.add(cells[found->second].sums);
      }
    }
    features.push_back(around.feature(cell.first));
  }
  return features;
}

std::vector<ScanPoint> moved(const std::vector<ScanPoint>& points, const Pose2& pose) {
  std::vector<ScanPoint> result;
  result.reserve(points.size());
  const ToOuter outer(pose);
  for (const ScanPoint& p : points) {
    result.push_back(
        {outer(p.at), p.straight() ? outer.turned(p.normal) : p.normal, p.chance, p.height});
  }
  return result;
}

std::vector<ScanPoint> thinned(const std::vector<ScanPoint>& points, double cell_m) {
  std::vector<ScanPoint> order = points;
  std::stable_sort(order.begin(), order.end(), [](const ScanPoint& a, const ScanPoint& b) {
    if (a.straight() != b.straight()) return a.straight();
    return a.at.squaredNorm() < b.at.squaredNorm();
  });
  std::unordered_map<std::uint64_t, bool> taken;
  std::vector<ScanPoint> kept;
  for (const ScanPoint& p : order) {
    // Followed points one above the other are as many.
    const long level = p.followed() ? std::lround(p.height / kNear_m) & 0xff : 0;
    const std::uint64_t key = cellOf(p.at, cell_m) ^ (static_cast<std::uint64_t>(level) << 24U);
    if (taken.emplace(key, true).second) kept.push_back(p);
  }
  return kept;
}

}  // namespace handmap
