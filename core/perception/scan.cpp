#include "core/perception/scan.h"

#include <algorithm>
#include <cmath>

#include "core/base/median.h"
#include "core/perception/constants.h"
#include "core/perception/range_walls.h"

namespace handmap {

using namespace perception;

namespace {

std::size_t directionOf(double bearing) {
  const auto index = static_cast<long>(std::lround((bearing + kPi) / kDirection));
  return static_cast<std::size_t>(index) % kDirections;
}

float bearingOf(std::size_t direction) {
  const double bearing = -kPi + static_cast<double>(direction) * kDirection;
  return static_cast<float>(direction == 0 ? kPi : bearing);
}

void keepNearest(Ray& kept, const Ray& ray) {
  if (kept.range == 0.0F || ray.range < kept.range) kept = ray;
}

}  // namespace

std::vector<RangePoint> likelyWalls(const Scan& scan) {
  std::vector<RangePoint> points;
  for (const Ray& ray : scan.rays) {
    if (!showsWall(ray)) continue;
    points.push_back(
        {ray.range * std::cos(ray.bearing), ray.range * std::sin(ray.bearing), kTall_m, 1.0F});
  }
  return points;
}

bool Sweeps::areRegular(const std::vector<RangePoint>& points) {
  std::vector<float> bearings;
  for (const RangePoint& p : points) bearings.push_back(std::atan2(p.y, p.x));
  std::ranges::sort(bearings);
  std::vector<float> steps;
  for (std::size_t i = 1; i < bearings.size(); ++i) steps.push_back(bearings[i] - bearings[i - 1]);
  if (steps.empty()) return true;
  const auto usual = static_cast<double>(medianOf(steps));
  if (static_cast<double>(steps.size()) >= kAtFirst) {
    narrowest_ = narrowest_ > 0.0 ? std::min(narrowest_, usual) : usual;
  }
  const double most = kOneStep * usual;
  steps_ += static_cast<double>(steps.size());
  regular_ += static_cast<double>(
      std::ranges::count_if(steps, [&](float step) { return static_cast<double>(step) <= most; }));
  return regular_ + kAtFirst >= kRegular * (steps_ + kAtFirst);
}

double Sweeps::step() const { return std::max(narrowest_, kDirection); }

ScanBuilder::ScanBuilder(double range_limit_m)
    : range_limit_m_(range_limit_m), looked_at_(kDirections) {}

Scan ScanBuilder::operator()(const std::vector<RangePoint>& points,
                             const std::vector<WallPoint>& walls) {
  nearest_.assign(kDirections, Ray{});
  not_measured_.assign(kDirections, false);
  std::vector<RangePoint> returns;
  for (const RangePoint& p : points) {
    if (!isMeasured(p)) {
      not_measured_[directionOf(std::atan2(p.y, p.x))] = true;
    } else if (std::isfinite(p.z) && std::hypot(p.x, p.y) <= range_limit_m_) {
      returns.push_back(p);
    }
  }
  Scan scan;
  if (returns.empty()) return scan;  // the sensor was silent, or covered
  scan.ray_by_ray = givesOneReturnADirection(returns) && sweeps_.areRegular(returns);
  if (scan.ray_by_ray) {
    addRays(returns, scan);
  } else {
    addStanding(returns, walls);
  }
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (nearest_[i].range > 0.0F) scan.rays.push_back(nearest_[i]);
  }
  std::sort(scan.rays.begin(), scan.rays.end(),
            [](const Ray& a, const Ray& b) { return a.bearing < b.bearing; });
  return scan;
}

void ScanBuilder::addRays(const std::vector<RangePoint>& points, Scan& scan) {
  const bool tilted = !isPlanar(points);
  const auto beside = static_cast<std::size_t>(sweeps_.step() / 2.0 / kDirection);
  for (const RangePoint& p : points) {
    const float bearing = std::atan2(p.y, p.x);
    const std::size_t direction = directionOf(bearing);
    if (!looked_at_[direction]) scan.first_looked_at.push_back(bearingOf(direction));
    // What is nearer to this direction than to its neighbours is looked at by it.
    for (std::size_t i = 0; i <= 2 * beside; ++i) {
      looked_at_[(direction + kDirections - beside + i) % kDirections] = true;
    }
    const float range = std::hypot(p.x, p.y);
    if (tilted && p.z < kLevel_m) {
      keepNearest(nearest_[direction], {bearing, range, 0.0F, 0.0F, false});
      continue;
    }
    const float wall = std::clamp(p.w, 0.0F, 1.0F);
    keepNearest(nearest_[direction], {bearing, range, kScanSigma_m, wall, true});
  }
  addSilence();
}

/// A step apart, as returns are: between two that are one step apart nothing was looked at.
void ScanBuilder::addSilence() {
  const auto apart =
      static_cast<std::size_t>(std::ceil(kOneStep / 2.0 * sweeps_.step() / kDirection));
  const auto told = [&](std::size_t i) {
    return nearest_[i % kDirections].range > 0.0F || not_measured_[i % kDirections];
  };
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (not_measured_[i]) looked_at_[i] = true;  // but it had not looked there all the while
    bool near = told(i);
    for (std::size_t k = 1; k < apart && !near; ++k) {
      near = told(i + k) || told(i + kDirections - k);
    }
    if (near || !looked_at_[i]) continue;
    nearest_[i] = {bearingOf(i), static_cast<float>(range_limit_m_), 0.0F, 0.0F, false};
  }
}

void ScanBuilder::addStanding(const std::vector<RangePoint>& points,
                              const std::vector<WallPoint>& walls) {
  for (const WallPoint& p : walls) {
    const float bearing = std::atan2(p.y, p.x);
    keepNearest(nearest_[directionOf(bearing)],
                {bearing, std::hypot(p.x, p.y), p.sigma, p.weight, true});
  }
  std::vector<Ray> farthest(kDirections);
  for (const RangePoint& p : points) {
    const std::size_t direction = directionOf(std::atan2(p.y, p.x));
    const float range = std::hypot(p.x, p.y);
    if (range > farthest[direction].range) {
      farthest[direction] = {bearingOf(direction), range, 0.0F, 0.0F, false};
    }
  }
  for (std::size_t i = 0; i < kDirections; ++i) {
    if (nearest_[i].range == 0.0F) nearest_[i] = farthest[i];
  }
}

}  // namespace handmap
