#include "core/perception/local_map.h"

#include <algorithm>
#include <string>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "core/base/error.h"
#include "core/base/text.h"

namespace handmap {
namespace {

// A scan nearer than this to the one before it tells nothing new: a robot that waits keeps one.
constexpr double kMinStep_m = 0.1;
constexpr double kMinTurn = toRadians(1.0);
// Bounds memory for a robot that turns on the spot for ever.
constexpr std::size_t kMaxScans = 400;
constexpr int kMaxSide = 8192;    // cells
constexpr int kMaxRaySteps = 50;  // cells to either side, 2σ

// Within ±σ lies this share of a Gaussian. Smoothed votes are divided by it, so that a saturated
// straight wall as wide as 2σ of the smoothing has the value 1.
constexpr float kShareWithinSigma = 0.6827F;

/// Throws BadInput.
int sideOf(double cell_m, double range_m) {
  const double side = std::ceil(2.0 * range_m / cell_m);
  if (!(cell_m > 0.0 && side >= 1.0 && side <= kMaxSide)) {
    throwBadInput("local map", "cell and range",
                  formatNumber(cell_m) + " m and " + formatNumber(range_m) + " m",
                  "a square of 1 to " + std::to_string(kMaxSide) + " cells a side");
  }
  return static_cast<int>(side);
}

double stepLength(const Pose2& from, const Pose2& to) {
  return (to.position() - from.position()).norm();
}

bool nearlySame(const Pose2& a, const Pose2& b) {
  return stepLength(a, b) < kMinStep_m &&
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

/// Adds votes to a map, each spread along its ray by its own σ.
class Voter {
 public:
  explicit Voter(LocalMap& map) : map_(map) {
    for (int steps = 0; steps <= kMaxRaySteps; ++steps) kernels_.push_back(rayKernel(steps));
  }

  /// `point` and the `origin` of its ray in the frame of the map.
  void vote(const Vec2& origin, const Vec2& point, const WallPoint& wall) {
    const double range = (point - origin).norm();
    const auto steps =
        range > 0.0 ? std::lround(std::min(2.0 * static_cast<double>(wall.sigma) / map_.cell(),
                                           static_cast<double>(kMaxRaySteps)))
                    : 0L;
    const Vec2 step = steps > 0 ? Vec2((point - origin) * (map_.cell() / range)) : Vec2::Zero();
    Vec2 p = point - static_cast<double>(steps) * step;
    for (const float share : kernels_[static_cast<std::size_t>(steps)]) {
      add(p, wall.weight * share);
      p += step;
    }
  }

 private:
  void add(const Vec2& p, float weight) {
    const int column = map_.columnOf(p.x());
    const int row = map_.columnOf(p.y());
    if (column < 0 || row < 0 || column >= map_.cells().cols || row >= map_.cells().rows) return;
    map_.cells()(row, column) += weight;
  }

  LocalMap& map_;
  std::vector<std::vector<float>> kernels_;  ///< by steps
};

/// Votes to values 0 … 1. Saturation comes before smoothing: a dense near wall is as sure as a
/// far one and no wider.
void render(LocalMap& map, const LocalMapOptions& options) {
  cv::Mat1f& cells = map.cells();
  const double sigma_cells = options.smoothing_sigma_m / map.cell();
  cv::min(cells, options.saturation_votes, cells);
  if (sigma_cells > 0.0) {
    cv::GaussianBlur(cells, cells, {}, sigma_cells, sigma_cells, cv::BORDER_CONSTANT);
  }
  const double share = sigma_cells > 0.0 ? kShareWithinSigma : 1.0;
  cells *= 1.0 / (options.saturation_votes * share);
  cv::min(cells, 1.0, cells);
}

}  // namespace

LocalMap::LocalMap(double cell_m, double range_m)
    : cell_(cell_m),
      range_(range_m),
      cells_(cv::Mat1f::zeros(sideOf(cell_m, range_m), sideOf(cell_m, range_m))) {}

LocalMapBuilder::LocalMapBuilder(double range_m, const LocalMapOptions& options)
    : range_(range_m), options_(options) {
  sideOf(options.cell_m, range_m);  // throws before the first observation rather than at it
  if (!(options.saturation_votes > 0.0)) {
    throwBadInput("local map", "saturation_votes", formatNumber(options.saturation_votes),
                  "a positive number");
  }
}

LocalMap LocalMapBuilder::add(const Pose2& odometry, bool standing, std::vector<WallPoint> walls) {
  if (standing) scans_.clear();
  if (scans_.size() >= 2 &&
      nearlySame(scans_[scans_.size() - 2].odometry, scans_.back().odometry)) {
    scans_.pop_back();
  }
  const double travelled =
      scans_.empty() ? 0.0
                     : scans_.back().travelled_m + stepLength(scans_.back().odometry, odometry);
  scans_.push_back({odometry, travelled, std::move(walls)});
  while (scans_.size() > kMaxScans || travelled - scans_.front().travelled_m > options_.path_m) {
    scans_.pop_front();
  }

  LocalMap map(options_.cell_m, range_);
  Voter voter(map);
  for (const Scan& scan : scans_) {
    const Pose2 placed = between(odometry, scan.odometry);
    const Vec2 ahead = unitVector(placed.heading);
    for (const WallPoint& wall : scan.walls) {
      const Vec2 turned =
          static_cast<double>(wall.x) * ahead + static_cast<double>(wall.y) * perpendicular(ahead);
      voter.vote(placed.position(), placed.position() + turned, wall);
    }
  }
  render(map, options_);
  return map;
}

}  // namespace handmap
