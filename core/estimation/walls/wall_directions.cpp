#include "core/estimation/walls/wall_directions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

namespace {

/// Points on a line, summed up.
class LinePiece {
 public:
  void add(const Vec2& point, double noise_m) {
    if (count_ == 0.0) first_ = point;
    const Vec2 p = point - first_;
    count_ += 1.0;
    sum_ += p;
    squares_ += p * p.transpose();
    noise_ += noise_m * noise_m + perception::kWall_m * perception::kWall_m;
    length_ = p.norm();
  }
  double length() const { return length_; }
  void fit() {
    const Vec2 mean = sum_ / count_;
    const Eigen::Matrix2d spread = squares_ / count_ - mean * mean.transpose();
    const double difference = spread(0, 0) - spread(1, 1);
    heading_ = 0.5 * std::atan2(2.0 * spread(0, 1), difference);
    const double root = std::hypot(difference, 2.0 * spread(0, 1));
    along_ = 0.5 * (spread.trace() + root);
    across_ = std::max(0.5 * (spread.trace() - root), 0.0);
  }
  double heading() const { return heading_; }
  /// One σ of the heading, by the noise expected.
  double headingSigma() const { return std::sqrt(noise_ / along_) / count_; }
  bool isStraight() const { return across_ < 2.0 * noise_ / count_; }

 private:
  Vec2 first_ = Vec2::Zero();
  Vec2 sum_ = Vec2::Zero();
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
  double count_ = 0.0;
  double noise_ = 0.0;
  double length_ = 0.0;
  double heading_ = 0.0;
  double along_ = 0.0;
  double across_ = 0.0;
};

}  // namespace

void WallDirections::add(const Frame& frame, const Pose2& pose, const SensorModel& sensor) {
  for (double& votes : votes_) votes *= kForgetting;
  const std::vector<FrameRay>& rays = frame.rays;
  const auto is_wall = [](const FrameRay& ray) { return ray.sight.label >= kLooksLikeAWall; };
  for (std::size_t begin = 0; begin < rays.size();) {
    LinePiece piece;
    std::size_t last = begin;
    std::size_t end = begin;
    bool voted = false;
    for (; end < rays.size() && rays[end].bearing - rays[last].bearing < kGap; ++end) {
      if (!is_wall(rays[end])) continue;
      const double range = rays[end].sight.range;
      piece.add(pose.toOuter({range * rays[end].x, range * rays[end].y}),
                sensor.measured().noise.at(range));
      last = end;
      if (piece.length() < kLeastWall_m) continue;
      piece.fit();
      if (!piece.isStraight() || piece.length() > kMostPiece_m) break;
      if (piece.headingSigma() > kTilt) continue;
      const double quarters = piece.heading() / (kPi / 2.0);
      const auto bin = static_cast<std::size_t>((quarters - std::floor(quarters)) * kBins);
      votes_[bin % kBins] += piece.length();
      voted = true;
      break;
    }
    // Pieces overlap by a half: where one wall ends and the next begins is not known.
    begin = std::max(begin + 1, voted ? (begin + end) / 2 : begin + (end - begin) / 4);
  }
}

double WallDirections::around(std::size_t bin) const {
  return votes_[(bin + kBins - 1) % kBins] + votes_[bin] + votes_[(bin + 1) % kBins];
}

std::vector<double> WallDirections::peaks() const {
  const double all = std::accumulate(votes_.begin(), votes_.end(), 0.0);
  const double least = std::max(kLeastVotes_m, kLeastShare * all);
  std::vector<std::size_t> order(kBins);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return around(a) > around(b); });
  std::vector<double> peaks;
  for (const std::size_t bin : order) {
    if (around(bin) < least) break;
    if (around(bin) < std::max(around((bin + kBins - 1) % kBins), around((bin + 1) % kBins)))
      continue;
    const double heading = (static_cast<double>(bin) + 0.5) * kBin;
    const auto is_near = [&](double other) {
      return std::abs(directionError(heading, other)) < kDirectionsApart / 2.0;
    };
    if (std::none_of(peaks.begin(), peaks.end(), is_near)) peaks.push_back(heading);
  }
  return peaks;
}

}  // namespace handmap
