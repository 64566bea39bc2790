#include "core/estimation/smoothing/sight_factors.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/smoothing/constants.h"

namespace handmap {

using namespace smoothing;

namespace {

/// The returns of the frame from the walls of the box. What one frame says of a wall is off as a
/// whole, however many returns there are.
bool addReturns(const Frame& frame, const Box& box, const SensorModel& sensor,
                const SightErrors& errors, SightEquations& equations) {
  const BoxSlabs slabs(box, frame.pose);
  if (slabs.inside() || !slabs.inReach(sensor.rangeLimit())) return false;
  const BoxView view(box, frame.pose);
  const ReturnFactors factor_of(frame.pose, box, sensor, errors);
  std::array<SightEquations, 4> walls;
  std::array<double, 4> information{};
  view.forRays(frame.rays, [&](const FrameRay& ray) {
    if (ray.sight.label == walls::kSilent) return;
    const Entry entry = view.entry(ray);
    if (entry.distance < 0.0F) return;
    const auto factor = factor_of(ray, entry);
    if (!factor) return;
    const auto wall = static_cast<std::size_t>(entry.wall);
    walls[wall].add(*factor);
    information[wall] += factor->weight;
  });
  bool seen = false;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (information[k] == 0.0) continue;
    equations.add(walls[k],
                  1.0 / (1.0 + information[k] * errors.systematic_m * errors.systematic_m));
    seen = true;
  }
  return seen;
}

}  // namespace

ReturnFactors::ReturnFactors(const Pose2& pose, const Box& box, const SensorModel& sensor,
                             const SightErrors& errors)
    : pose_(pose),
      box_(box),
      sensor_(sensor),
      errors_(errors),
      cos_(std::cos(pose.heading)),
      sin_(std::sin(pose.heading)),
      along_(unitVector(box.heading)),
      normals_(box.normals()) {}

std::optional<ScalarFactor<SightEquations::kSize>> ReturnFactors::operator()(
    const FrameRay& ray, const Entry& entry) const {
  const double noise = sensor_.measured().noise.at(entry.distance);
  // Near the limit only the returns that noise makes shorter come back.
  if (entry.distance + kNearLimit * noise > sensor_.rangeLimit()) return std::nullopt;
  const double cosine = std::max(entry.cosine, buildings::kLeastCosine);
  const double slack = errors_.slack_m / cosine;
  const double sigma = std::sqrt(noise * noise + slack * slack);
  const double squared = static_cast<double>(entry.distance * entry.distance);
  const double range_error =
      static_cast<double>(ray.sight.range - entry.distance) - errors_.bias_per_m * squared;
  if (std::abs(range_error) > walls::kReach * sigma) return std::nullopt;
  const Vec2& n = normals_[static_cast<std::size_t>(entry.wall)];
  // At the hypothesised point: at the measured one the noise would be in the slopes as well.
  const Vec2 direction(cos_ * ray.x - sin_ * ray.y, sin_ * ray.x + cos_ * ray.y);
  const Vec2 turned = static_cast<double>(entry.distance) * direction;
  const Vec2 from_pivot = pose_.position() + turned - box_.pivot;
  ScalarFactor<SightEquations::kSize> factor;
  factor.slope.head<kPoseSize>() << n.x(), n.y(), n.dot(perpendicular(turned));
  const std::array<double, 4> slopes =
      box_.slopes(box_.shareAt(box_.pivot + from_pivot, along_), n, along_);
  for (std::size_t k = 0; k < 4; ++k) {
    factor.slope[SightEquations::kBox + static_cast<int>(k)] = -slopes[k];
  }
  factor.slope[SightEquations::kBox + 4] = perpendicular(n).dot(from_pivot);
  factor.slope[SightEquations::kBias] = -squared * n.dot(direction);
  const double clutter_error = sensor_.clutterError(ray.sight.label, noise);
  factor.residual = (range_error - clutter_error) * n.dot(direction);
  factor.weight = sensor_.responsibility(ray.sight.label, range_error, sigma) /
                  (sigma * sigma * cosine * cosine);
  return factor;
}

ScalarFactor<SightEquations::kSize> endFactor(const Pose2& pose, const Box& box, const SeenEnd& end,
                                              const SightErrors& errors) {
  const Vec2 corner = box.corner(end.corner);
  const Vec2 offset = corner - pose.position();
  const Vec2 slope = perpendicular(offset) / offset.squaredNorm();
  ScalarFactor<SightEquations::kSize> factor;
  factor.slope.head<kPoseSize>() << -slope.x(), -slope.y(), -1.0;
  const std::array<double, 4> slopes = box.slopes(box.share(end.corner), slope);
  for (std::size_t k = 0; k < 4; ++k) {
    factor.slope[SightEquations::kBox + static_cast<int>(k)] = slopes[k];
  }
  factor.slope[SightEquations::kBox + 4] = slope.dot(perpendicular(corner - box.pivot));
  const double bearing = std::atan2(offset.y(), offset.x()) - pose.heading;
  const double sigma = std::hypot(end.sigma, kEndsAreWorse * errors.systematic_m / offset.norm());
  factor.residual = normalizedAngle(bearing - end.bearing);
  factor.weight = 1.0 / (sigma * sigma);
  return factor;
}

std::optional<SightEquations> sightEquations(const Frame& frame, const Box& box,
                                             const SensorModel& sensor, const SightErrors& errors) {
  SightEquations equations;
  if (!addReturns(frame, box, sensor, errors, equations)) return std::nullopt;
  for (const SeenEnd& end : silhouette(box, frame, sensor)) {
    equations.add(endFactor(frame.pose, box, end, errors));
  }
  return equations;
}

}  // namespace handmap
