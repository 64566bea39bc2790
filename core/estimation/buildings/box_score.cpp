#include "core/estimation/buildings/box_score.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/buildings/constants.h"

namespace handmap {

using namespace buildings;

BoxScorer::BoxScorer(const Box& box, std::span<const Frame* const> frames,
                     const SensorModel& sensor, std::size_t stride)
    : frames_(frames), sensor_(sensor), stride_(stride) {
  lookAt(box);
}

void BoxScorer::lookAt(const Box& box) {
  around_ = box.corners();
  turned_to_ = box.frame();
  looking_.clear();
  for (const Frame* frame : frames_) {
    const BoxView view(box, frame->pose);
    if (!view.inReach(sensor_.rangeLimit() + kNear_m)) continue;
    // Seen from the nearest corner, what lies within kNear_m of the box.
    double nearest = (box.rectangle().centre - frame->pose.position()).norm();
    for (const Vec2& corner : around_) {
      nearest = std::min(nearest, (corner - frame->pose.position()).norm());
    }
    const double margin = nearest > kNear_m ? std::asin(kNear_m / nearest) : kPi / 2.0;
    const auto widened = static_cast<float>(view.inReach(kNear_m) ? 2.0 * kPi : margin);
    const float span = std::min(view.highBearing() - view.lowBearing() + 2.0F * widened,
                                static_cast<float>(2.0 * kPi));
    const float low = std::max(view.lowBearing() - widened, static_cast<float>(-2.0 * kPi));
    looking_.push_back(
        {frame, raysBetween(frame->rays, low, low + span), PoseAtBox(box, frame->pose)});
  }
}

/// What changes is mostly how far the box reaches: then there is nothing to do.
void BoxScorer::turnTo(const Box& box) {
  if (box.frame() == turned_to_) return;
  turned_to_ = box.frame();
  for (Looking& looking : looking_) looking.pose = PoseAtBox(box, looking.frame->pose);
}

double BoxScorer::operator()(const Box& box) {
  const std::array<Vec2, 4> corners = box.corners();
  const bool near =
      std::equal(corners.begin(), corners.end(), around_.begin(),
                 [](const Vec2& a, const Vec2& b) { return (a - b).norm() <= kNear_m; });
  near ? turnTo(box) : lookAt(box);
  double score = 0.0;
  for (const Looking& looking : looking_) {
    const BoxSlabs slabs(box, looking.pose);
    if (slabs.inside()) return kRobotInside;
    if (!slabs.inReach(sensor_.rangeLimit())) continue;
    float sum = 0.0F;
    forRays(
        looking.rays,
        [&](const FrameRay& ray) {
          const Entry entry = slabs.entry(ray);
          if (entry.distance < 0.0F) return;
          sum += sensor_(ray.sight, entry.distance,
                         kWallSlack_m / std::max(entry.cosine, kLeastCosine));
        },
        stride_);
    score += static_cast<double>(sum) * static_cast<double>(stride_);
  }
  return score;
}

}  // namespace handmap
