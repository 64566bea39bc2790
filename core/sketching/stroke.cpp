#include "core/sketching/stroke.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handmap {

namespace {

constexpr double kOvershoot = 0.2;         // of the stroke's length, at each end
constexpr double kMeetingDistance = 0.06;  // of the stroke's length

std::vector<double> lengthsAlong(std::span<const Vec2> line) {
  std::vector<double> lengths(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    lengths[i] = lengths[i - 1] + (line[i] - line[i - 1]).norm();
  return lengths;
}

double distanceToOutline(const Polygon& outline, const Vec2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
    least =
        std::min(least, distanceTo(Segment{outline[i], outline[(i + 1) % outline.size()]}, point));
  return least;
}

double meanSquaredDistance(const Polygon& points, const Polygon& outline) {
  double sum = 0.0;
  for (const Vec2& point : points) {
    const double distance = distanceToOutline(outline, point);
    sum += distance * distance;
  }
  return sum / static_cast<double>(points.size());
}

/// The corners between `first` and `last` of the line that stand out from the chord.
void keepCorners(std::span<const Vec2> line, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& kept) {
  double most = tolerance;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double distance = distanceTo(Segment{line[first], line[last]}, line[i]);
    if (distance <= most) continue;
    most = distance;
    at = i;
  }
  if (at == first) return;
  kept[at] = true;
  keepCorners(line, first, at, tolerance, kept);
  keepCorners(line, at, last, tolerance, kept);
}

}  // namespace

Polygon closedStroke(std::span<const Vec2> stroke) {
  Polygon line(stroke.begin(), stroke.end());
  line.erase(std::unique(line.begin(), line.end()), line.end());
  if (line.size() < 3) return {};
  const std::vector<double> along = lengthsAlong(line);
  const double length = along.back();
  // Where the end of the stroke comes nearest to its beginning.
  std::size_t begin = 0;
  std::size_t end = line.size() - 1;
  double nearest = std::min((line.front() - line.back()).norm(), kMeetingDistance * length);
  for (std::size_t i = 0; i < line.size() && along[i] <= kOvershoot * length; ++i) {
    for (std::size_t j = line.size() - 1; j > i && along[j] >= (1.0 - kOvershoot) * length; --j) {
      const double distance = (line[i] - line[j]).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      begin = i;
      end = j;
    }
  }
  Polygon closed(line.begin() + static_cast<std::ptrdiff_t>(begin),
                 line.begin() + static_cast<std::ptrdiff_t>(end) + 1);
  while (closed.size() > 1 && closed.front() == closed.back()) closed.pop_back();
  return closed.size() < 3 ? Polygon() : closed;
}

Polygon evenlySampled(const Polygon& outline, std::size_t count) {
  Polygon ring = outline;
  ring.push_back(outline.front());
  const std::vector<double> along = lengthsAlong(ring);
  Polygon samples;
  std::size_t i = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double travelled = along.back() * static_cast<double>(n) / static_cast<double>(count);
    while (i + 2 < ring.size() && along[i + 1] <= travelled) ++i;
    const double piece = along[i + 1] - along[i];
    const double t = piece > 0.0 ? (travelled - along[i]) / piece : 0.0;
    samples.push_back(ring[i] + t * (ring[i + 1] - ring[i]));
  }
  return samples;
}

Polygon simplified(const Polygon& outline, double tolerance) {
  if (outline.size() < 4) return outline;
  // Two corners that surely stay: the farthest from the middle, and the farthest from that one.
  const auto farthest_from = [&](const Vec2& point) {
    return std::ranges::max_element(
        outline, {}, [&](const Vec2& corner) { return (corner - point).squaredNorm(); });
  };
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : outline) middle += corner / static_cast<double>(outline.size());
  Polygon ring(outline.size() + 1);
  std::rotate_copy(outline.begin(), farthest_from(middle), outline.end(), ring.begin());
  ring.back() = ring.front();
  const auto opposite = static_cast<std::size_t>(
      std::ranges::max_element(
          ring, {}, [&](const Vec2& corner) { return (corner - ring.front()).squaredNorm(); }) -
      ring.begin());
  std::vector<bool> kept(ring.size(), false);
  kept.front() = kept[opposite] = true;
  keepCorners(ring, 0, opposite, tolerance, kept);
  keepCorners(ring, opposite, ring.size() - 1, tolerance, kept);
  Polygon corners;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    if (kept[i]) corners.push_back(ring[i]);
  return corners;
}

double diagonalOf(const Polygon& points) {
  const Bounds bounds = boundsOf(points);
  return (bounds.high - bounds.low).norm();
}

double misfitOf(const Polygon& samples, const Polygon& outline) {
  const double there = meanSquaredDistance(samples, outline);
  const double back = meanSquaredDistance(evenlySampled(outline, samples.size() / 2), samples);
  return std::sqrt((there + back) / 2.0);
}

}  // namespace handmap
