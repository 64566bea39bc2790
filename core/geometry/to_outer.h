// A pose that many points are moved by.
#pragma once

#include "core/geometry/pose2.h"

namespace handmap {

/// Pose2::toOuter() for many points.
class ToOuter {
 public:
  explicit ToOuter(const Pose2& pose)
      : x_(pose.x), y_(pose.y), cos_(std::cos(pose.heading)), sin_(std::sin(pose.heading)) {}

  Vec2 operator()(const Vec2& point) const {
    return {x_ + cos_ * point.x() - sin_ * point.y(), y_ + sin_ * point.x() + cos_ * point.y()};
  }
  Vec2 turned(const Vec2& direction) const {
    return {cos_ * direction.x() - sin_ * direction.y(),
            sin_ * direction.x() + cos_ * direction.y()};
  }

 private:
  double x_;
  double y_;
  double cos_;
  double sin_;
};

}  // namespace handmap
