#include "core/sketching/squaring.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace handmap {

namespace {

/// A straight wall: a point that its line goes through, its way, its length.
struct Wall {
  Vec2 at;
  double heading;
  double length;
};

std::vector<Wall> laidOut(const Polygon& polygon, double common, double tolerance) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double heading = std::atan2(edge.y(), edge.x());
    const double turn = turnToParallel(heading, common);
    walls.push_back({a + edge / 2.0,
                     normalizedAngle(std::abs(turn) <= tolerance ? heading + turn : heading),
                     edge.norm()});
  }
  return walls;
}

bool areParallel(const Wall& a, const Wall& b) {
  return std::abs(std::sin(a.heading - b.heading)) < 1e-6;
}

/// Two walls as one: where their lengths balance.
Wall joined(const Wall& a, const Wall& b) {
  const double length = a.length + b.length;
  return {(a.at * a.length + b.at * b.length) / length,
          a.length >= b.length ? a.heading : b.heading, length};
}

void joinParallels(std::vector<Wall>& walls) {
  for (std::size_t i = 0; i < walls.size() && walls.size() > 3;) {
    const std::size_t next = (i + 1) % walls.size();
    if (!areParallel(walls[i], walls[next])) {
      ++i;
      continue;
    }
    walls[i] = joined(walls[i], walls[next]);
    walls.erase(walls.begin() + static_cast<std::ptrdiff_t>(next));
    i = 0;
  }
}

}  // namespace

double commonHeading(const Polygon& polygon) {
  std::complex<double> sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 edge = polygon[(i + 1) % polygon.size()] - polygon[i];
    // Four times the angle: all four sides of a rectangle point the same way. Long walls tell it
    // more surely than many short ones.
    sum += std::polar(edge.squaredNorm(), 4.0 * std::atan2(edge.y(), edge.x()));
  }
  const double heading = std::fmod(std::arg(sum) / 4.0 + kPi, kPi / 2.0);
  return heading > kPi / 2.0 - 1e-12 || heading < 1e-12 ? 0.0 : heading;
}

double turnToParallel(double heading_rad, double target_rad) {
  return std::remainder(target_rad - heading_rad, kPi / 2.0);
}

std::optional<Polygon> squaredUp(const Polygon& polygon, double tolerance_rad) {
  std::vector<Wall> walls = laidOut(polygon, commonHeading(polygon), tolerance_rad);
  joinParallels(walls);
  if (walls.size() < 3) return std::nullopt;
  Polygon corners;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& before = walls[(i + walls.size() - 1) % walls.size()];
    const Wall& wall = walls[i];
    const Vec2 along = unitVector(before.heading);
    const double sine = cross(along, unitVector(wall.heading));
    if (std::abs(sine) < 1e-6) return std::nullopt;
    corners.push_back(before.at +
                      along * (cross(wall.at - before.at, unitVector(wall.heading)) / sine));
  }
  if (signedArea(corners) < 0.0) std::ranges::reverse(corners);
  return isSimple(corners) ? std::optional(corners) : std::nullopt;
}

}  // namespace handmap
