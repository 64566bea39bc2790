#include "core/estimation/box_score.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr double kRobotInside = -1e6;
constexpr float kMiss = -1.0F;
constexpr double kAround = 2.0;      // metres that corners may move before the rays are sought anew
constexpr double kMostMargin = 1.6;  // radians

}  // namespace

BoxSlabs::BoxSlabs(const Box& box, const Pose2& robot) {
  const Pose2 own = between({box.pivot.x(), box.pivot.y(), box.heading}, robot);
  x_ = static_cast<float>(own.x);
  y_ = static_cast<float>(own.y);
  cos_ = static_cast<float>(std::cos(own.heading));
  sin_ = static_cast<float>(std::sin(own.heading));
  high_x_ = static_cast<float>(box.reach[0]);
  high_y_ = static_cast<float>(box.reach[1]);
  low_x_ = static_cast<float>(-box.reach[2]);
  low_y_ = static_cast<float>(-box.reach[3]);
  const float dx = std::max({0.0F, x_ - high_x_, low_x_ - x_});
  const float dy = std::max({0.0F, y_ - high_y_, low_y_ - y_});
  nearest_ = std::sqrt(dx * dx + dy * dy);
}

BoxView::BoxView(const Box& box, const Pose2& robot) : BoxSlabs(box, robot) {
  const Vec2 middle = robot.toOwn(box.rectangle().centre);
  const double direction = std::atan2(middle.y(), middle.x());
  double low = 0.0;
  double high = 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 corner = robot.toOwn(box.corner(k));
    const double turn = normalizedAngle(std::atan2(corner.y(), corner.x()) - direction);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  low_bearing_ = static_cast<float>(direction + low);
  high_bearing_ = static_cast<float>(direction + high);
}

Entry BoxSlabs::entry(const FrameRay& ray) const {
  const float dx = cos_ * ray.x - sin_ * ray.y;
  const float dy = sin_ * ray.x + cos_ * ray.y;
  Entry entry{kMiss, 0.0F, 0};
  if (x_ > high_x_ ? dx < 0.0F : x_ < low_x_ && dx > 0.0F) {
    const float distance = ((dx < 0.0F ? high_x_ : low_x_) - x_) / dx;
    const float y = y_ + distance * dy;
    if (y >= low_y_ && y <= high_y_) entry = {distance, std::abs(dx), dx < 0.0F ? 0 : 2};
  }
  if (entry.distance < 0.0F && (y_ > high_y_ ? dy < 0.0F : y_ < low_y_ && dy > 0.0F)) {
    const float distance = ((dy < 0.0F ? high_y_ : low_y_) - y_) / dy;
    const float x = x_ + distance * dx;
    if (x >= low_x_ && x <= high_x_) entry = {distance, std::abs(dy), dy < 0.0F ? 1 : 3};
  }
  return entry;
}

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
      nearest = std::min(nearest, (box.corner(k) - frame->pose.position()).norm());
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
    if ((box.corner(k) - around_.corner(k)).norm() <= kAround) continue;
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
