#include "core/evaluation/rigid_motion.h"

#include <numeric>

namespace handmap {

namespace {

Vec2 meanOf(const std::vector<Vec2>& points) {
  const Vec2 sum = std::accumulate(points.begin(), points.end(), Vec2(Vec2::Zero()));
  return sum / static_cast<double>(points.size());
}

}  // namespace

Pose2 bestRigidMotion(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  if (from.empty()) return {};
  const Vec2 from_mean = meanOf(from);
  const Vec2 to_mean = meanOf(to);
  double sine = 0.0;
  double cosine = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    sine += cross(from[i] - from_mean, to[i] - to_mean);
    cosine += (from[i] - from_mean).dot(to[i] - to_mean);
  }
  const double turn = std::atan2(sine, cosine);
  const Vec2 shift = to_mean - Pose2{0.0, 0.0, turn}.toOuter(from_mean);
  return {shift.x(), shift.y(), turn};
}

}  // namespace handmap
