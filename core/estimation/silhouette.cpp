#include "core/estimation/silhouette.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handmap {

namespace {

constexpr double kSideways = 2.5;     // metres around the corner that are looked at
constexpr double kWidest = 0.15;      // radians, the same
constexpr double kMostSigma = 1.2;    // metres; what is known no better is not told
constexpr double kPoseSigma = 0.002;  // radians

struct Boundary {
  double bearing;  ///< from the corner, positive outwards
  double sum;      ///< log ratio of the rays further in
};

/// A return where the wall is expected that is not taken for a wall says neither that the building
/// goes on (it may be a tree) nor that it ends (not every wall is recognised).
float evenHanded(const SensorModel& sensor, Sight sight, float distance, float slack_m) {
  const float ratio = sensor(sight, distance, slack_m);
  if (sight.label == SensorModel::kSilent || ratio > 0.0F) return ratio;
  sight.label = SensorModel::kLabels - 1;
  return std::min(0.0F, sensor(sight, distance, slack_m));
}

/// The bearing at which the sum of what is inside is best, as mean and σ.
std::optional<SeenEnd> located(const std::vector<Boundary>& boundaries) {
  if (boundaries.size() < 4) return std::nullopt;
  const double best =
      std::max_element(boundaries.begin(), boundaries.end(),
                       [](const Boundary& a, const Boundary& b) { return a.sum < b.sum; })
          ->sum;
  double total = 0.0;
  double mean = 0.0;
  double square = 0.0;
  for (const Boundary& boundary : boundaries) {
    const double weight = std::exp(boundary.sum - best);
    total += weight;
    mean += weight * boundary.bearing;
    square += weight * boundary.bearing * boundary.bearing;
  }
  const double outermost = std::exp(boundaries.back().sum - best) / total;
  const double innermost = std::exp(boundaries.front().sum - best) / total;
  if (outermost > 0.05 || innermost > 0.05) return std::nullopt;
  mean /= total;
  const double spacing = (boundaries.back().bearing - boundaries.front().bearing) /
                         static_cast<double>(boundaries.size() - 1);
  const double variance = square / total - mean * mean + spacing * spacing / 12.0;
  return SeenEnd{0, mean, std::sqrt(std::max(variance, 0.0) + kPoseSigma * kPoseSigma)};
}

}  // namespace

std::vector<SeenEnd> silhouette(const Box& box, const Frame& frame, const SensorModel& sensor) {
  std::vector<SeenEnd> ends;
  const Vec2 robot = frame.pose.position();
  const std::size_t walls = box.walls();
  std::array<bool, kMostWalls> visible{};
  for (std::size_t k = 0; k < walls; ++k) {
    visible[k] = box.normal(k).dot(robot - box.corner(k)) > 0.0;
  }
  for (std::size_t k = 0; k < walls; ++k) {
    const std::size_t next = (k + 1) % walls;
    if (visible[k] == visible[next] || cross(box.normal(k), box.normal(next)) < 0.0) continue;
    const std::size_t wall = visible[k] ? k : next;
    const Vec2 offset = box.corner(k) - robot;
    const double distance = offset.norm();
    if (distance > sensor.rangeLimit() || distance < 1.0) continue;
    // Counter-clockwise along the walls, wall k ends at corner k and wall k + 1 begins there: seen
    // from outside its inside lies to the right of the corner, or to the left.
    const double outwards = visible[k] ? -1.0 : 1.0;
    const double bearing = normalizedAngle(std::atan2(offset.y(), offset.x()) - frame.pose.heading);
    const double width = std::min(kWidest, kSideways / distance);
    const Vec2 normal = box.normal(wall);
    const Vec2 own_normal = frame.pose.toOwn(frame.pose.position() + normal);
    const double to_wall = normal.dot(offset);

    std::vector<std::pair<double, float>> rays;  // bearing from the corner, ratio
    forRaysBetween(frame.rays, static_cast<float>(bearing - width),
                   static_cast<float>(bearing + width), [&](const FrameRay& ray) {
                     const double off =
                         outwards * normalizedAngle(static_cast<double>(ray.bearing) - bearing);
                     const double cosine = own_normal.x() * ray.x + own_normal.y() * ray.y;
                     const double along = to_wall / cosine;
                     float ratio = 0.0F;
                     if (cosine < -0.03 && along < sensor.rangeLimit()) {
                       ratio = evenHanded(sensor, ray.sight, static_cast<float>(along),
                                          kWallSlack / static_cast<float>(-cosine));
                     }
                     rays.emplace_back(off, ratio);
                   });
    std::sort(rays.begin(), rays.end());
    std::vector<Boundary> boundaries;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < rays.size(); ++i) {
      sum += static_cast<double>(rays[i].second) / sensor.options().temper;
      boundaries.push_back({(rays[i].first + rays[i + 1].first) / 2.0, sum});
    }
    std::optional<SeenEnd> end = located(boundaries);
    if (!end || end->sigma * distance > kMostSigma) continue;
    end->corner = k;
    end->bearing = normalizedAngle(bearing + outwards * end->bearing);
    ends.push_back(*end);
  }
  return ends;
}

}  // namespace handmap
