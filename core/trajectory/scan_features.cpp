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

/// How noisy a return is, and how thick a straight piece there may be.
struct Thickness {
  double noise_m2;
  double most_m;

  Thickness(double range_m, const ScanNoise& noise)
      : noise_m2(noise.sigma(range_m) * noise.sigma(range_m)),
        most_m(kRough_m + kRoughPerMetre * range_m) {}
};

/// How far neighbours either side make a piece long enough for its noise. 0 for stereo: what is
/// noisier 20 m away than the map has cells errs with its neighbours, and bends as they do.
double reach(double range_m, const ScanNoise& noise) {
  if (!noise.knows(2.0 * kBin_m) || noise.sigma(2.0 * kBin_m) > kCell_m) return 0.0;
  return 0.5 * kLeastLength * kNoisy * noise.sigma(range_m);
}

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
  ScanPoint feature(const Vec2& at, const Thickness& thick) const {
    if (count_ < kLeastPoints) return {at, Vec2::Zero(), 1.0, thick.noise_m2};
    const Vec2 mean = sum_ / count_;
    const Eigen::Matrix2d scatter = squares_ - mean * sum_.transpose();
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(scatter / (count_ - 2));
    const double thickness = std::sqrt(std::max(axes.eigenvalues()(0), 0.0));
    const double length = std::sqrt(12.0 * axes.eigenvalues()(1));
    if (thickness > thick.most_m || length < kLeastLength * thickness)
      return {at, Vec2::Zero(), 0.0, thick.noise_m2};
    const Vec2 normal = axes.eigenvectors().col(0);
    const double variance = std::max(axes.eigenvalues()(0), 0.0);
    // Off its line by noise, which is taken out, and by how rough the wall is.
    const double by_noise = thick.noise_m2 / (thick.noise_m2 + kRough_m * kRough_m);
    return {at - by_noise * normal.dot(at - mean) * normal,
            normal.dot(mean) > 0.0 ? Vec2(-normal) : normal,
            variance / axes.eigenvalues()(1) / count_, variance};
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

std::vector<ScanPoint> planarFeatures(const std::vector<RangePoint>& points,
                                      const ScanNoise& noise) {
  std::vector<Polar> scan;
  scan.reserve(points.size());
  for (const RangePoint& p : points) {
    const Vec2 at(p.x, p.y);
    scan.push_back({std::atan2(at.y(), at.x()), at});
  }
  std::stable_sort(scan.begin(), scan.end(),
                   [](const Polar& a, const Polar& b) { return a.bearing < b.bearing; });
  const double step = spacing(scan);
  std::vector<bool> gap(scan.size(), true);  // behind each return
  for (std::size_t i = 0; i + 1 < scan.size(); ++i) {
    const double range_m = std::min(scan[i].at.norm(), scan[i + 1].at.norm());
    const double usual_m = std::max(kNear_m, kGapSpacings * step * range_m);
    gap[i] = (scan[i + 1].at - scan[i].at).norm() > std::max(usual_m, reach(range_m, noise));
  }
  std::vector<ScanPoint> features(scan.size());
  for (std::size_t i = 0; i < scan.size(); ++i) {
    Thickness thick(scan[i].at.norm(), noise);
    const double reach_m = reach(scan[i].at.norm(), noise);
    thick.most_m = std::max(thick.most_m, 2.0 * reach_m / kLeastLength);
    const auto near = [&](std::size_t j) { return (scan[j].at - scan[i].at).norm() < reach_m; };
    LineSums sums;
    sums.add(scan[i].at);
    for (std::size_t j = i; j > 0 && !gap[j - 1] && (i - j < kNeighbours || near(j)); --j) {
      sums.add(scan[j - 1].at);
    }
    for (std::size_t j = i; !gap[j] && (j - i < kNeighbours || near(j)); ++j) {
      sums.add(scan[j + 1].at);
    }
    features[i] = sums.feature(scan[i].at, thick);
  }
  return features;
}

std::vector<ScanPoint> standingFeatures(const std::vector<Vec2>& points, const ScanNoise& noise) {
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
    features.push_back(around.feature(cell.first, {cell.first.norm(), noise}));
  }
  return features;
}

std::vector<ScanPoint> moved(const std::vector<ScanPoint>& points, const Pose2& pose) {
  std::vector<ScanPoint> result;
  result.reserve(points.size());
  const ToOuter outer(pose);
  for (const ScanPoint& p : points) {
    result.push_back({outer(p.at), p.straight() ? outer.turned(p.normal) : p.normal, p.chance,
                      p.variance, p.height});
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
