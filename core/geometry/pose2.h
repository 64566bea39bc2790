// Positions and poses in the plane. Metres and radians; headings counter-clockwise from +x.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace handmap {

using Vec2 = Eigen::Vector2d;

inline constexpr double kPi = std::numbers::pi;
constexpr double toRadians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double toDegrees(double radians) { return radians * (180.0 / kPi); }

/// The same angle in (-π, π].
inline double normalizedAngle(double angle_rad) {
  if (std::abs(angle_rad) < kPi) return angle_rad;  // mostly, and a division costs
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped == -kPi ? kPi : wrapped;
}

inline Vec2 unitVector(double heading_rad) {
  return {std::cos(heading_rad), std::sin(heading_rad)};
}
/// Counter-clockwise by a right angle.
inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A pose of one frame in another: x, y in metres, heading in radians.
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;

  Vec2 position() const { return {x, y}; }
  /// From this pose's own frame to the frame that the pose is given in.
  Vec2 toOuter(const Vec2& point) const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return {x + c * point.x() - s * point.y(), y + s * point.x() + c * point.y()};
  }
  /// The inverse of toOuter().
  Vec2 toOwn(const Vec2& point) const {
    const double c = std::cos(heading);
    const double s = std::sin(heading);
    return {c * (point.x() - x) + s * (point.y() - y), c * (point.y() - y) - s * (point.x() - x)};
  }
  bool operator==(const Pose2&) const = default;
};

/// The pose `inner`, given in the frame of `outer`, in the frame that `outer` is given in.
inline Pose2 operator*(const Pose2& outer, const Pose2& inner) {
  const Vec2 p = outer.toOuter(inner.position());
  return {p.x(), p.y(), normalizedAngle(outer.heading + inner.heading)};
}

inline Pose2 inverse(const Pose2& pose) {
  const Vec2 p = pose.toOwn(Vec2::Zero());
  return {p.x(), p.y(), normalizedAngle(-pose.heading)};
}

/// `to` in the frame of `from`: from * between(from, to) == to.
inline Pose2 between(const Pose2& from, const Pose2& to) {
  const Vec2 p = from.toOwn(to.position());
  return {p.x(), p.y(), normalizedAngle(to.heading - from.heading)};
}

/// On the way from `a` (t = 0) to `b` (t = 1), straight, turning the short way.
inline Pose2 interpolated(const Pose2& a, const Pose2& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
          normalizedAngle(a.heading + t * normalizedAngle(b.heading - a.heading))};
}

}  // namespace handmap
