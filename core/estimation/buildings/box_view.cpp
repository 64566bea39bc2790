#include "core/estimation/buildings/box_view.h"

#include <algorithm>
#include <cmath>

namespace handmap {

PoseAtBox::PoseAtBox(const Box& box, const Pose2& robot) {
  const Pose2 own = between(box.frame(), robot);
  x = static_cast<float>(own.x);
  y = static_cast<float>(own.y);
  cos = static_cast<float>(std::cos(own.heading));
  sin = static_cast<float>(std::sin(own.heading));
}

BoxSlabs::BoxSlabs(const Box& box, const PoseAtBox& robot) : robot_(robot) {
  const auto& [x, y, cos, sin] = robot_;
  high_x_ = static_cast<float>(box.reach[0]);
  high_y_ = static_cast<float>(box.reach[1]);
  low_x_ = static_cast<float>(-box.reach[2]);
  low_y_ = static_cast<float>(-box.reach[3]);
  const float dx = std::max({0.0F, x - high_x_, low_x_ - x});
  const float dy = std::max({0.0F, y - high_y_, low_y_ - y});
  nearest_ = std::sqrt(dx * dx + dy * dy);
  inside_ = nearest_ == 0.0F;
  if (!box.outline) return;
  for (const Vec2& share : *box.outline) {
    corner_x_[corners_] = low_x_ + static_cast<float>(share.x()) * (high_x_ - low_x_);
    corner_y_[corners_] = low_y_ + static_cast<float>(share.y()) * (high_y_ - low_y_);
    ++corners_;
  }
  if (!inside_) return;
  // A ray in any direction leaves a polygon that it begins in once more than it enters it.
  inside_ = false;
  for (std::size_t i = 0, last = corners_ - 1; i < corners_; last = i++) {
    if ((corner_y_[i] > y) == (corner_y_[last] > y)) continue;
    const float share = (y - corner_y_[i]) / (corner_y_[last] - corner_y_[i]);
    if (x < corner_x_[i] + share * (corner_x_[last] - corner_x_[i])) inside_ = !inside_;
  }
}

Entry BoxSlabs::entryIntoOutline(float dx, float dy) const {
  Entry entry;
  for (std::size_t i = 0, last = corners_ - 1; i < corners_; last = i++) {
    const float along_x = corner_x_[i] - corner_x_[last];
    const float along_y = corner_y_[i] - corner_y_[last];
    const float facing = dx * along_y - dy * along_x;  // outward normal times direction
    if (facing >= 0.0F) continue;
    const float to_x = corner_x_[last] - robot_.x;
    const float to_y = corner_y_[last] - robot_.y;
    const float distance = (to_x * along_y - to_y * along_x) / facing;
    const float at = (to_x * dy - to_y * dx) / facing;
    if (distance < 0.0F || at < 0.0F || at > 1.0F) continue;
    if (entry.distance >= 0.0F && distance >= entry.distance) continue;
    entry = {distance, -facing / std::hypot(along_x, along_y), static_cast<int>(i)};
  }
  return entry;
}

BoxView::BoxView(const Box& box, const Pose2& robot) : BoxSlabs(box, robot) {
  const Vec2 middle = robot.toOwn(box.rectangle().centre);
  const double direction = std::atan2(middle.y(), middle.x());
  double low = 0.0;
  double high = 0.0;
  for (const Vec2& outer : box.boxCorners()) {
    const Vec2 corner = robot.toOwn(outer);
    const double turn = normalizedAngle(std::atan2(corner.y(), corner.x()) - direction);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  if (inBox()) {
    low = -kPi;
    high = kPi;
  }
  low_bearing_ = static_cast<float>(direction + low);
  high_bearing_ = static_cast<float>(direction + high);
}

}  // namespace handmap
