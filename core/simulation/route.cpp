#include "core/simulation/route.h"

#include <algorithm>

#include "core/simulation/ray_cast.h"

namespace handmap {

namespace {

constexpr double kLeastLeg = 1e-3;
constexpr double kCornerReach = 4.0;  // corners are rounded this far before and behind
constexpr double kStandOff = 3.0;     // before a wall in the way
constexpr double kComesBack_m = 1.0;  // choice: within the width of a robot

double distanceBetween(const Segment& a, const Segment& b) {
  const auto sides = [](const Segment& s, const Segment& other) {
    return cross(s.b - s.a, other.a - s.a) * cross(s.b - s.a, other.b - s.a);
  };
  if (sides(a, b) < 0.0 && sides(b, a) < 0.0) return 0.0;
  return std::min({distanceTo(a, b.a), distanceTo(a, b.b), distanceTo(b, a.a), distanceTo(b, a.b)});
}

std::vector<Vec2> straightAhead(const Map& map) {
  const Vec2 origin = map.start->position();
  const Vec2 direction = unitVector(map.start->heading);
  double last_corner = 0.0;
  double free = kNoHit;
  for (const Building& building : map.buildings) {
    const Polygon corners = building.footprint();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Segment wall{corners[i], corners[(i + 1) % corners.size()]};
      free = std::min(free, rayToSegment(origin, direction, wall) - kStandOff);
      last_corner = std::max(last_corner, direction.dot(corners[i] - origin));
    }
  }
  return {origin, origin + std::max(std::min(free, last_corner), 0.0) * direction};
}

}  // namespace

Route::Route(const std::vector<Vec2>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Segment leg{points[i - 1], points[i]};
    if (leg.length() < kLeastLeg / 2.0) continue;
    legs_.push_back(leg);
    ends_.push_back(length += leg.length());
  }
}

std::size_t Route::legAt(double s) const {
  const auto end = std::upper_bound(ends_.begin(), ends_.end() - 1, s);
  return static_cast<std::size_t>(end - ends_.begin());
}

Vec2 Route::pointAt(double s) const {
  const std::size_t i = legAt(s);
  const Segment& leg = legs_[i];
  return leg.b + (s - ends_[i]) / leg.length() * (leg.b - leg.a);
}

/// The mean of the legs over a window; the derivative of that is the chord of the window.
Pose2 Route::poseAt(double s) const {
  constexpr int kSamples = 16;
  Vec2 mean = Vec2::Zero();
  for (int i = 0; i < kSamples; ++i) {
    mean += pointAt(s + kCornerReach * ((2.0 * i + 1.0) / kSamples - 1.0));
  }
  mean /= kSamples;
  Vec2 chord = pointAt(s + kCornerReach) - pointAt(s - kCornerReach);
  if (chord.norm() < 1e-6) chord = legs_[legAt(s)].b - legs_[legAt(s)].a;
  return {mean.x(), mean.y(), std::atan2(chord.y(), chord.x())};
}

Route::Projection Route::project(const Vec2& point) const {
  Projection best{0.0, kNoHit};
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    const double distance = handmap::distanceTo(legs_[i], point);
    if (distance >= std::abs(best.offset)) continue;
    const double length = legs_[i].length();
    const Vec2 direction = (legs_[i].b - legs_[i].a) / length;
    const Vec2 from_end = point - legs_[i].b;
    best = {ends_[i] + std::clamp(direction.dot(from_end), -length, 0.0),
            std::copysign(distance, cross(direction, from_end))};
  }
  return best;
}

double Route::distanceTo(const Polygon& polygon) const {
  if (contains(polygon, legs_.front().a)) return 0.0;
  double nearest = kNoHit;
  for (const Segment& leg : legs_) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Segment edge{polygon[i], polygon[(i + 1) % polygon.size()]};
      nearest = std::min(nearest, distanceBetween(leg, edge));
    }
  }
  return nearest;
}

std::vector<Vec2> routePoints(const Map& map) {
  if (map.start && map.route.empty()) return straightAhead(map);
  std::vector<Vec2> points = map.route;
  if (map.start) points.insert(points.begin(), map.start->position());
  return points;
}

std::optional<Route> routeOf(const Map& map) {
  const std::vector<Vec2> points = routePoints(map);
  double span = 0.0;
  for (const Vec2& point : points) span = std::max(span, (point - points.front()).norm());
  if (span < kLeastLeg) return std::nullopt;
  return Route(points);
}

std::optional<std::vector<Vec2>> roundAgain(const std::vector<Vec2>& points, int rounds) {
  const auto comes_back = [&](const Vec2& point) {
    return (point - points.front()).norm() < kComesBack_m;
  };
  const auto away = std::find_if_not(points.begin(), points.end(), comes_back);
  const auto back = std::find_if(points.rbegin(), std::make_reverse_iterator(away), comes_back);
  if (back.base() == away) return std::nullopt;
  std::vector<Vec2> result = {points.front()};
  for (int i = 0; i < rounds; ++i) result.insert(result.end(), points.begin() + 1, back.base());
  result.insert(result.end(), back.base(), points.end());
  return result;
}

}  // namespace handmap
