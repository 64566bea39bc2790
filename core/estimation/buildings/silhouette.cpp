#include "core/estimation/buildings/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace buildings;

namespace {

struct Boundary {
  double outwards;  ///< bearing from the corner, radians
  double sum;       ///< log ratio of the rays further in
};

/// A return where the wall is expected that is not taken for a wall says neither that the building
/// goes on (it may be a tree) nor that it ends (not every wall is recognised).
float evenHanded(const SensorModel& sensor, const RayBeside& ray) {
  if (std::isinf(ray.distance)) return 0.0F;
  if (sensor.isBefore(ray.sight, ray.distance, ray.slack)) return sensor.blocked();
  const float ratio = sensor(ray.sight, ray.distance, ray.slack);
  if (ray.sight.label == walls::kSilent || ratio > 0.0F) return ratio;
  const Sight wall_like{ray.sight.range, walls::kLabels - 1};
  return std::min(0.0F, sensor(wall_like, ray.distance, ray.slack));
}

/// The bearing at which the sum of what is inside is best, as mean and σ.
std::optional<SeenEnd> located(const std::vector<Boundary>& boundaries) {
  if (boundaries.size() < kLeastBearings) return std::nullopt;
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
    mean += weight * boundary.outwards;
    square += weight * boundary.outwards * boundary.outwards;
  }
  const double outermost = std::exp(boundaries.back().sum - best) / total;
  const double innermost = std::exp(boundaries.front().sum - best) / total;
  if (outermost > kFallen || innermost > kFallen) return std::nullopt;
  mean /= total;
  const double spacing = (boundaries.back().outwards - boundaries.front().outwards) /
                         static_cast<double>(boundaries.size() - 1);
  const double variance = square / total - mean * mean + spacing * spacing / 12.0;
  return SeenEnd{0, mean, std::sqrt(std::max(variance, 0.0) + kPoseSigma * kPoseSigma)};
}

}  // namespace

std::vector<VisibleEnd> visibleEnds(const Box& box, const Frame& frame, const SensorModel& sensor) {
  std::vector<VisibleEnd> ends;
  const Vec2 robot = frame.pose.position();
  const std::array<Vec2, 4> normals = box.normals();
  const std::array<Vec2, 4> corners = box.corners();
  std::array<bool, 4> visible{};
  for (std::size_t k = 0; k < visible.size(); ++k) {
    visible[k] = normals[k].dot(robot - corners[k]) > 0.0;
  }
  for (std::size_t k = 0; k < visible.size(); ++k) {
    const std::size_t next = (k + 1) % visible.size();
    if (visible[k] == visible[next]) continue;
    const Vec2 offset = corners[k] - robot;
    const double distance = offset.norm();
    if (distance > sensor.rangeLimit() || distance < kNearest_m) continue;
    // Counter-clockwise along the walls, wall k ends at corner k and wall k + 1 begins there: seen
    // from outside its inside lies to the right of the corner, or to the left.
    const double sign = visible[k] ? -1.0 : 1.0;
    const double bearing = normalizedAngle(std::atan2(offset.y(), offset.x()) - frame.pose.heading);
    const double width = std::min(kWidest, kSideways_m / distance);
    const Vec2& normal = normals[visible[k] ? k : next];
    const Vec2 own_normal = frame.pose.toOwn(robot + normal);
    const double to_wall = normal.dot(offset);
    VisibleEnd end{k, bearing, sign, distance, {}};
    const RayStretches beside_it = raysBetween(frame.rays, static_cast<float>(bearing - width),
                                               static_cast<float>(bearing + width));
    forRays(beside_it, [&](const FrameRay& ray) {
      const double off = sign * normalizedAngle(static_cast<double>(ray.bearing) - bearing);
      const double cosine = own_normal.x() * ray.x + own_normal.y() * ray.y;
      RayBeside beside{off, std::numeric_limits<float>::infinity(), 0.0F, ray.sight};
      if (cosine < -kGrazing && to_wall / cosine < sensor.rangeLimit()) {
        beside.distance = static_cast<float>(to_wall / cosine);
        beside.slack = kWallSlack_m / static_cast<float>(-cosine);
      }
      end.rays.push_back(beside);
    });
    std::sort(end.rays.begin(), end.rays.end(),
              [](const RayBeside& a, const RayBeside& b) { return a.outwards < b.outwards; });
    ends.push_back(std::move(end));
  }
  return ends;
}

std::vector<SeenEnd> silhouette(const Box& box, const Frame& frame, const SensorModel& sensor) {
  std::vector<SeenEnd> seen;
  for (const VisibleEnd& visible : visibleEnds(box, frame, sensor)) {
    std::vector<Boundary> boundaries;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < visible.rays.size(); ++i) {
      sum += static_cast<double>(evenHanded(sensor, visible.rays[i])) / walls::kTemper;
      boundaries.push_back({(visible.rays[i].outwards + visible.rays[i + 1].outwards) / 2.0, sum});
    }
    std::optional<SeenEnd> end = located(boundaries);
    if (!end || end->sigma * visible.distance > kMostSigma_m) continue;
    end->corner = visible.corner;
    end->bearing = normalizedAngle(visible.bearing + visible.sign * end->bearing);
    seen.push_back(*end);
  }
  return seen;
}

}  // namespace handmap
