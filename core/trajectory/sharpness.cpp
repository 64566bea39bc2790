#include "core/trajectory/sharpness.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/random.h"
#include "core/geometry/to_outer.h"
#include "core/perception/constants.h"
#include "core/trajectory/constants.h"

namespace handmap {

using namespace trajectory;

namespace {

struct Placed {
  Vec2 at;
  Eigen::Vector3d covariance;  ///< xx, xy, yy
  double travelled_m;
};

using Cell = std::int64_t;
Cell cellOf(std::int64_t x, std::int64_t y) { return (x << 32) ^ (y & 0xffffffff); }
std::int64_t indexOf(double v) {
  return static_cast<std::int64_t>(std::floor(v / kSharpnessCell_m));
}

std::vector<Placed> placed(const std::vector<SharpnessFrame>& frames,
                           const std::vector<Pose2>& poses) {
  std::vector<Placed> points;
  double travelled = 0.0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i > 0) travelled += (poses[i].position() - poses[i - 1].position()).norm();
    if (!frames[i]) continue;
    const ToOuter outer(poses[i]);
    for (const SharpnessPoint& p : *frames[i]) {
      const Vec2 at = outer(p.at);
      const Vec2 ray = (at - poses[i].position()).normalized();
      const double along = p.sigma * p.sigma + perception::kWall_m * perception::kWall_m;
      points.push_back({at,
                        {along * ray.x() * ray.x() + 0.5 * kRound_m2, along * ray.x() * ray.y(),
                         along * ray.y() * ray.y() + 0.5 * kRound_m2},
                        travelled});
    }
  }
  return points;
}

/// Density at `p` of what `other` says.
double density(const Placed& p, const Placed& other) {
  const Eigen::Vector3d c = p.covariance + other.covariance;
  const Vec2 d = p.at - other.at;
  const double determinant = c(0) * c(2) - c(1) * c(1);
  const double square =
      (c(2) * d.x() * d.x() - 2.0 * c(1) * d.x() * d.y() + c(0) * d.y() * d.y()) / determinant;
  if (!(square < kMostSquare)) return 0.0;
  return std::exp(-0.5 * square) / (2.0 * kPi * std::sqrt(determinant));
}

}  // namespace

double sharpnessOf(const std::vector<SharpnessFrame>& frames, const std::vector<Pose2>& poses,
                   const SharpnessOptions& options) {
  const std::vector<Placed> points = placed(frames, poses);
  if (points.empty()) return 0.0;
  std::unordered_map<Cell, std::vector<const Placed*>> cells;
  for (const Placed& p : points) {
    cells[cellOf(indexOf(p.at.x()), indexOf(p.at.y()))].push_back(&p);
  }
  RandomStream random(options.seed);
  double sum = 0.0;
  for (int sample = 0; sample < options.samples; ++sample) {
    const Placed& p =
        points[static_cast<std::size_t>(random.index(static_cast<int>(points.size())))];
    double seen = 0.0;
    for (std::int64_t dy = -1; dy <= 1; ++dy) {
      for (std::int64_t dx = -1; dx <= 1; ++dx) {
        const auto cell = cells.find(cellOf(indexOf(p.at.x()) + dx, indexOf(p.at.y()) + dy));
        if (cell == cells.end()) continue;
        for (const Placed* other : cell->second) {
          if (std::abs(other->travelled_m - p.travelled_m) <= options.apart_m) continue;
          seen += density(p, *other);
        }
      }
    }
    sum += std::log(kBackground + seen);
  }
  return sum / options.samples;
}

}  // namespace handmap
