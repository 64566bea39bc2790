#include "core/estimation/buildings/clutter_estimate.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/buildings/constants.h"
#include "core/estimation/buildings/silhouette.h"

namespace handmap {

using namespace buildings;

void ClutterEstimate::Share::forget() {
  blocked *= kForgetting;
  rays *= kForgetting;
}

void ClutterEstimate::add(const Frame& frame, std::span<const FoundBox> boxes,
                          const SensorModel& sensor) {
  looked_m_ *= kForgetting;
  wall_like_ *= kForgetting;
  others_ *= kForgetting;
  at_walls_.forget();
  beside_.forget();
  for (const FoundBox& found : boxes) {
    addBefore(frame, found.box, sensor);
    addAtEnds(frame, found.box, sensor);
  }
}

/// The last metres before what may be the wall itself, of rays that come so far.
void ClutterEstimate::addBefore(const Frame& frame, const Box& box, const SensorModel& sensor) {
  const BoxView view(box, frame.pose);
  if (view.inside() || !view.inReach(sensor.rangeLimit())) return;
  view.forRays(frame.rays, [&](const FrameRay& ray) {
    const Entry entry = view.entry(ray);
    if (entry.distance < 0.0F || entry.cosine < kSteep) return;
    const auto end = static_cast<double>(entry.distance - sensor.reach(entry.distance));
    const double begin = end - kNear_m;
    const auto range = static_cast<double>(ray.sight.range);
    if (begin < 0.0 || range < begin) return;
    looked_m_ += std::min(range, end) - begin;
    if (range > end || ray.sight.label == walls::kSilent) return;
    const double wall = SensorModel::shareOf(ray.sight.label);
    wall_like_ += wall;
    others_ += 1.0 - wall;
  });
}

void ClutterEstimate::addAtEnds(const Frame& frame, const Box& box, const SensorModel& sensor) {
  for (const VisibleEnd& end : visibleEnds(box, frame, sensor)) {
    for (const RayBeside& ray : end.rays) {
      if (std::isinf(ray.distance) || std::abs(ray.outwards) * end.distance < kAgreed_m) continue;
      Share& share = ray.outwards < 0.0 ? at_walls_ : beside_;
      share.rays += 1.0;
      if (sensor.isBefore(ray.sight, ray.distance, ray.slack)) share.blocked += 1.0;
    }
  }
}

Clutter ClutterEstimate::measured() const {
  const double ratio = at_walls_.blocked / at_walls_.rays * beside_.rays / beside_.blocked;
  return {wall_like_ / looked_m_, others_ / looked_m_, std::max(ratio, 1.0)};
}

bool differMuch(const Clutter& a, const Clutter& b) {
  const auto differ = [](double one, double other, double least) {
    return std::abs(one - other) > kMuch * other + least;
  };
  return differ(a.wall_like_per_m, b.wall_like_per_m, kMuchDensity) ||
         differ(a.others_per_m, b.others_per_m, kMuchDensity) ||
         differ(a.at_walls, b.at_walls, 0.0);
}

}  // namespace handmap
