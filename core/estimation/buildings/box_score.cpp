#include "core/estimation/buildings/box_score.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr double kRobotInside = -1e6;  // nats
constexpr double kAround = 2.0;  // metres that corners may move before rays are sought anew; choice
constexpr double kMostMargin = 1.6;  // radians; choice: a quarter turn

}  // namespace

BoxScorer::BoxScorer(const Box& box, std::span<const Frame* const> frames,
                     const SensorModel& sensor, int stride)
    : frames_(frames), sensor_(sensor), stride_(stride) {
  lookAt(box);
}

void BoxScorer::lookAt(const Box& box) {
  around_ = box;
  looking_.clear();
  for (const Frame* frame : frames_) {
    const BoxView view(box, frame->pose);
    if (!view.inReach(sensor_.rangeLimit() + kAround)) continue;
    // Seen from the nearest corner, what lies within kAround of the box.
    double nearest = (box.rectangle().centre - frame->pose.position()).norm();
    for (std::size_t k = 0; k < 4; ++k) {
      nearest = std::min(nearest, (box.boxCorner(k) - frame->pose.position()).norm());
    }
    const double margin =
        nearest > kAround ? std::min(std::asin(kAround / nearest), kMostMargin) : kMostMargin;
    const auto widened = static_cast<float>(view.inReach(kAround) ? 2.0 * kPi : margin);
    const float span = std::min(view.highBearing() - view.lowBearing() + 2.0F * widened,
                                static_cast<float>(2.0 * kPi));
    const float low = std::max(view.lowBearing() - widened, static_cast<float>(-2.0 * kPi));
    looking_.push_back({frame, low, low + span});
  }
}

double BoxScorer::operator()(const Box& box) {
  for (std::size_t k = 0; k < 4; ++k) {
    if ((box.boxCorner(k) - around_.boxCorner(k)).norm() <= kAround) continue;
    lookAt(box);
    break;
  }
  double score = 0.0;
  for (const Looking& looking : looking_) {
    const BoxSlabs slabs(box, looking.frame->pose);
    if (slabs.inside()) return kRobotInside;
    if (!slabs.inReach(sensor_.rangeLimit())) continue;
    float sum = 0.0F;
    forRaysBetween(
        looking.frame->rays, looking.low, looking.high,
        [&](const FrameRay& ray) {
          const Entry entry = slabs.entry(ray);
          if (entry.distance < 0.0F) return;
          sum += sensor_(ray.sight, entry.distance, kWallSlack / std::max(entry.cosine, 0.02F));
        },
        stride_);
    score += static_cast<double>(sum) * stride_;
  }
  return score;
}

}  // namespace handmap
