#include "core/perception/local_map.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/gaussian.h"
#include "core/base/phrase.h"
#include "core/base/text.h"
#include "core/perception/constants.h"
#include "core/perception/vote_grid.h"

namespace handmap {

using namespace perception;

namespace {

/// Throws BadInput.
int sideOf(double cell_m, double range_m) {
  const double side = std::ceil(2.0 * range_m / cell_m);
  if (!(cell_m > 0.0 && side >= 1.0 && side <= kMaxSide)) {
    throwBadInput(phrase("local map"), phrase("cell and range"),
                  phrase("{} m and {} m", formatNumber(cell_m), formatNumber(range_m)),
                  phrase("a square of 1 to {} cells a side", kMaxSide));
  }
  return static_cast<int>(side);
}

double stepLength(const Pose2& from, const Pose2& to) {
  return (to.position() - from.position()).norm();
}

bool nearlySame(const Pose2& a, const Pose2& b) {
  return stepLength(a, b) < kMapCell_m &&
         std::abs(normalizedAngle(a.heading - b.heading)) < kMinTurn;
}

/// A Gaussian over the cells from -steps to steps, which are 2σ; sums to 1.
std::vector<float> rayKernel(int steps) {
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int i = -steps; i <= steps; ++i) {
    const float sigmas = 2.0F * static_cast<float>(i) / static_cast<float>(std::max(1, steps));
    kernel.push_back(std::exp(-0.5F * sigmas * sigmas));
    sum += kernel.back();
  }
  for (float& value : kernel) value /= sum;
  return kernel;
}

/// Casts votes into a grid, each spread along its ray by its own σ.
class Voter {
 public:
  Voter(VoteGrid& grid, double cell_m, double range_m)
      : grid_(grid), cell_(cell_m), range_(range_m) {
    for (int steps = 0; steps <= kMaxRaySteps; ++steps) kernels_.push_back(rayKernel(steps));
  }

  /// `point` and the `origin` of its ray in the frame of the map.
  void vote(const Vec2& origin, const Vec2& point, const WallPoint& wall) {
    const double range = (point - origin).norm();
    const auto steps = range > 0.0
                           ? std::lround(std::min(2.0 * static_cast<double>(wall.sigma) / cell_,
                                                  static_cast<double>(kMaxRaySteps)))
                           : 0L;
    const Vec2 step = steps > 0 ? Vec2((point - origin) / range) : Vec2::Zero();
    const Vec2 p =
        point / cell_ + Vec2::Constant(range_ / cell_) - static_cast<double>(steps) * step;
    auto x = static_cast<std::int64_t>(p.x() * kFraction);
    auto y = static_cast<std::int64_t>(p.y() * kFraction);
    const auto dx = static_cast<std::int64_t>(step.x() * kFraction);
    const auto dy = static_cast<std::int64_t>(step.y() * kFraction);
    for (const float share : kernels_[static_cast<std::size_t>(steps)]) {
      grid_.add(x >> 16, y >> 16, wall.weight * share);
      x += dx;
      y += dy;
    }
  }

 private:
  VoteGrid& grid_;
  double cell_;
  double range_;
  std::vector<std::vector<float>> kernels_;  ///< by steps
};

}  // namespace

LocalMap::LocalMap(double cell_m, double range_m)
    : cell_(cell_m),
      range_(range_m),
      cells_(cv::Mat1f::zeros(sideOf(cell_m, range_m), sideOf(cell_m, range_m))) {}

LocalMapBuilder::LocalMapBuilder(double range_m, const LocalMapOptions& options)
    : range_(range_m), options_(options) {
  sideOf(options.cell_m, range_m);
  if (!(options.saturation_votes > 0.0)) {
    throwBadInput(phrase("local map"), "saturation_votes", formatNumber(options.saturation_votes),
                  phrase("a positive number"));
  }
}

LazyLocalMap LocalMapBuilder::add(const Pose2& odometry, bool standing,
                                  std::vector<WallPoint> walls) {
  if (standing) scans_.clear();
  if (scans_.size() >= 2 &&
      nearlySame(scans_[scans_.size() - 2].odometry, scans_.back().odometry)) {
    scans_.pop_back();
  }
  const double travelled =
      scans_.empty() ? 0.0
                     : scans_.back().travelled_m + stepLength(scans_.back().odometry, odometry);
  scans_.push_back(
      {odometry, travelled, std::make_shared<const std::vector<WallPoint>>(std::move(walls))});
  while (scans_.size() > kMostScans || travelled - scans_.front().travelled_m > options_.path_m) {
    scans_.pop_front();
  }

  return LazyLocalMap(range_, [range = range_, options = options_,
                               scans = std::vector<Scan>(scans_.begin(), scans_.end())] {
    return render(range, options, scans);
  });
}

/// Around the last of the scans.
LocalMap LocalMapBuilder::render(double range_m, const LocalMapOptions& options,
                                 const std::vector<Scan>& scans) {
  VoteGrid votes(sideOf(options.cell_m, range_m), options.smoothing_sigma_m / options.cell_m);
  Voter voter(votes, options.cell_m, range_m);
  for (const Scan& scan : scans) {
    const Pose2 placed = between(scans.back().odometry, scan.odometry);
    const Vec2 ahead = unitVector(placed.heading);
    for (const WallPoint& wall : *scan.walls) {
      const Vec2 turned =
          static_cast<double>(wall.x) * ahead + static_cast<double>(wall.y) * perpendicular(ahead);
      voter.vote(placed.position(), placed.position() + turned, wall);
    }
  }
  // What is as wide as 2σ of the smoothing has the value 1. Saturation comes before smoothing: a
  // dense near wall is as sure as a far one and no wider.
  const double share = options.smoothing_sigma_m > 0.0 ? kWithinSigma : 1.0;
  LocalMap map(options.cell_m, range_m);
  votes.moveTo(map.cells(), static_cast<float>(options.saturation_votes),
               static_cast<float>(1.0 / (options.saturation_votes * share)));
  return map;
}

}  // namespace handmap
