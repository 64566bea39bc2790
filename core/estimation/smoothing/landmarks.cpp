#include "core/estimation/smoothing/landmarks.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/smoothing/constants.h"

namespace handmap {

using namespace smoothing;

namespace {

bool returned(const FrameRay& ray) { return ray.sight.label != walls::kSilent; }

/// Rays [begin, end) that return from one depth.
struct Group {
  std::size_t begin;
  std::size_t end;
};

class Grouping {
 public:
  Grouping(const std::vector<FrameRay>& rays, const SensorModel& sensor)
      : rays_(rays), sensor_(sensor) {}

  std::vector<Group> groups() const {
    std::vector<Group> groups;
    for (std::size_t i = 0; i < rays_.size();) {
      std::size_t end = i + 1;
      if (returned(rays_[i])) {
        while (end < rays_.size() && continues(end - 1, end)) ++end;
        groups.push_back({i, end});
      }
      i = end;
    }
    return groups;
  }

  /// What lies beside the group (on either side) is clearly farther.
  bool standsOut(const Group& group) const {
    const float range = rays_[group.begin].sight.range;
    return isBehind(group.begin, -1, range) && isBehind(group.end - 1, 1, range);
  }

 private:
  float tolerance(float range) const {
    return std::max(kDepth_m,
                    kDepthSigmas * static_cast<float>(sensor_.measured().noise.at(range)));
  }
  bool continues(std::size_t a, std::size_t b) const {
    return returned(rays_[b]) && rays_[b].bearing - rays_[a].bearing < kMostSpacing &&
           std::abs(rays_[b].sight.range - rays_[a].sight.range) < tolerance(rays_[a].sight.range);
  }
  /// Two rays beside, so that one stray return does not decide.
  bool isBehind(std::size_t from, int step, float range) const {
    const auto count = static_cast<long>(rays_.size());
    int behind = 0;
    for (int i = 1; i <= kBeside; ++i) {
      const long at = ((static_cast<long>(from) + i * step) % count + count) % count;
      const FrameRay& ray = rays_[static_cast<std::size_t>(at)];
      if (!returned(ray) || ray.sight.range > range + kApart_m + tolerance(range)) ++behind;
    }
    return behind == kBeside;
  }

  const std::vector<FrameRay>& rays_;
  const SensorModel& sensor_;
};

}  // namespace

std::vector<Sighting> compactThings(const std::vector<FrameRay>& rays, const SensorModel& sensor) {
  std::vector<Sighting> sightings;
  const Grouping grouping(rays, sensor);
  for (const Group& group : grouping.groups()) {
    const auto count = static_cast<int>(group.end - group.begin);
    if (count < kLeastLooks) continue;
    const float low = rays[group.begin].bearing;
    const float high = rays[group.end - 1].bearing;
    const float spacing = (high - low) / static_cast<float>(count - 1);
    float range = 0.0F;
    for (std::size_t i = group.begin; i < group.end; ++i) range += rays[i].sight.range;
    range /= static_cast<float>(count);
    const float width = range * (high - low + spacing);
    if (range > kFarthest_m || width > kWidest_m || !grouping.standsOut(group)) continue;
    // The mean depth of the near half of a circle is π/4 of its radius before the middle.
    const double middle = static_cast<double>(range + kMiddle * width);
    const double noise = sensor.measured().noise.at(middle) / std::sqrt(count);
    sightings.push_back({static_cast<double>(low + high) / 2.0, middle,
                         std::hypot(kShape_m / middle, kBearing * static_cast<double>(spacing)),
                         std::hypot(kRangeShape_m, noise), -1});
  }
  return sightings;
}

void Landmarks::associate(Frame& frame, const RangeNoise& noise, std::size_t most_frames) {
  std::vector<bool> taken(positions_.size());
  for (Sighting& sighting : frame.sightings) {
    const double range = sighting.range - noise.bias(sighting.range);
    const Vec2 place = frame.pose.toOuter(range * unitVector(sighting.bearing));
    double nearest = kApart_m;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (last_seen_[i] + most_frames < frame.number) continue;
      const double distance = (positions_[i] - place).norm();
      if (i < taken.size() && !taken[i] && distance < nearest) {
        nearest = distance;
        sighting.landmark = static_cast<int>(i);
      }
    }
    if (sighting.landmark < 0) {
      sighting.landmark = static_cast<int>(positions_.size());
      positions_.push_back(place);
      last_seen_.push_back(frame.number);
    } else {
      const auto landmark = static_cast<std::size_t>(sighting.landmark);
      taken[landmark] = true;
      last_seen_[landmark] = frame.number;
    }
  }
}

}  // namespace handmap
