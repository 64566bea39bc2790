#include "core/estimation/buildings/box_view.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/to_outer.h"

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
}

BoxView::BoxView(const Box& box, const Pose2& robot) : BoxSlabs(box, robot) {
  const ToOuter own(inverse(robot));
  const Vec2 middle = own(box.rectangle().centre);
  const double direction = std::atan2(middle.y(), middle.x());
  double low = 0.0;
  double high = 0.0;
  for (const Vec2& outer : box.corners()) {
    const Vec2 corner = own(outer);
    const double turn = normalizedAngle(std::atan2(corner.y(), corner.x()) - direction);
    low = std::min(low, turn);
    high = std::max(high, turn);
  }
  if (inside()) {
    low = -kPi;
    high = kPi;
  }
  low_bearing_ = static_cast<float>(direction + low);
  high_bearing_ = static_cast<float>(direction + high);
}

}  // namespace handmap
