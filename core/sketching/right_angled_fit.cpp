#include "core/sketching/right_angled_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "core/base/median.h"

namespace handmap {

namespace {

constexpr int kRounds = 6;
constexpr double kLeastNotch = 0.12;  // of the side that it shortens

/// Walls of an outline with right angles in its own frame, counter-clockwise: the even ones lie
/// along x at a y, the odd ones along y at an x. Wall i ends where wall i + 1 begins.
using Walls = std::vector<double>;

Polygon cornersOf(const Walls& walls) {
  Polygon corners;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const double before = walls[(i + walls.size() - 1) % walls.size()];
    corners.push_back(i % 2 == 0 ? Vec2(before, walls[i]) : Vec2(walls[i], before));
  }
  return corners;
}

std::size_t nearestWall(const Polygon& corners, const Vec2& point, double& distance) {
  std::size_t nearest = 0;
  distance = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double to_wall =
        distanceTo(Segment{corners[i], corners[(i + 1) % corners.size()]}, point);
    if (to_wall >= distance) continue;
    distance = to_wall;
    nearest = i;
  }
  return nearest;
}

double meanSquare(const Walls& walls, const Polygon& samples) {
  const Polygon corners = cornersOf(walls);
  double sum = 0.0;
  for (const Vec2& sample : samples) {
    double distance = 0.0;
    nearestWall(corners, sample, distance);
    sum += distance * distance;
  }
  return sum / static_cast<double>(samples.size());
}

/// Each wall in turn moved to the middle of the samples that are nearest to it.
Walls settled(Walls walls, const Polygon& samples) {
  for (int round = 0; round < kRounds; ++round) {
    const Polygon corners = cornersOf(walls);
    std::vector<std::vector<double>> nearest(walls.size());
    for (const Vec2& sample : samples) {
      double distance = 0.0;
      const std::size_t wall = nearestWall(corners, sample, distance);
      nearest[wall].push_back(wall % 2 == 0 ? sample.y() : sample.x());
    }
    for (std::size_t i = 0; i < walls.size(); ++i) {
      if (!nearest[i].empty()) walls[i] = medianOf(nearest[i]);
    }
  }
  return walls;
}

/// The direction of the walls modulo a right angle, from chords: long ones lie along walls, those
/// over a corner are short.
double headingOf(const Polygon& samples) {
  constexpr std::size_t kHalfChord = 4;
  std::complex<double> sum;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec2 chord = samples[(i + 2 * kHalfChord) % samples.size()] - samples[i];
    sum += std::polar(std::pow(chord.norm(), 4.0), 4.0 * std::atan2(chord.y(), chord.x()));
  }
  return std::arg(sum) / 4.0;
}

Polygon inFrame(const Polygon& samples, double heading) {
  Polygon own = samples;
  for (Vec2& sample : own) sample = Pose2{0.0, 0.0, heading}.toOwn(sample);
  return own;
}

Walls rectangleWalls(const Polygon& own) {
  const Bounds bounds = boundsOf(own);
  return settled({bounds.low.y(), bounds.high.x(), bounds.high.y(), bounds.low.x()}, own);
}

bool hasExtent(const Walls& rectangle) {
  return rectangle[1] > rectangle[3] && rectangle[2] > rectangle[0];
}

/// The walls of the rectangle with a corner cut out: corner 0 is low x and low y, then on counter-
/// clockwise; `in` is how far the notch reaches along x and y.
Walls notched(const Walls& r, int corner, const Vec2& in) {
  switch (corner) {
    case 0:
      return {r[0], r[1], r[2], r[3], r[0] + in.y(), r[3] + in.x()};
    case 1:
      return {r[0], r[1] - in.x(), r[0] + in.y(), r[1], r[2], r[3]};
    case 2:
      return {r[0], r[1], r[2] - in.y(), r[1] - in.x(), r[2], r[3]};
    default:
      return {r[0], r[1], r[2], r[3] + in.x(), r[2] - in.y(), r[3]};
  }
}

}  // namespace

Rectangle fittedRectangle(const Polygon& samples) {
  const double first = headingOf(samples);
  double best_heading = first;
  Walls best = rectangleWalls(inFrame(samples, first));
  double least = std::numeric_limits<double>::infinity();
  for (double step = toRadians(2.0); step > toRadians(0.2); step /= 2.0) {
    const double about = best_heading;
    for (int i = -3; i <= 3; ++i) {
      const double heading = about + i * step;
      const Polygon own = inFrame(samples, heading);
      const Walls walls = rectangleWalls(own);
      const double error =
          hasExtent(walls) ? meanSquare(walls, own) : std::numeric_limits<double>::infinity();
      if (error >= least) continue;
      least = error;
      best = walls;
      best_heading = heading;
    }
  }
  const Vec2 low(best[3], best[0]);
  const Vec2 high(best[1], best[2]);
  const Vec2 size = (high - low).cwiseMax(1e-3);
  return {Pose2{0.0, 0.0, best_heading}.toOuter((low + high) / 2.0), size.x(), size.y(),
          normalizedAngle(best_heading)};
}

std::optional<Polygon> fittedLShape(const Polygon& samples, const Rectangle& rectangle) {
  // The walls of an L pull the rectangle askew, so its own heading comes from the chords as well.
  std::optional<Polygon> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double heading : {rectangle.heading, headingOf(samples)}) {
    const Polygon own = inFrame(samples, heading);
    const Bounds bounds = boundsOf(own);
    const Walls outer = {bounds.low.y(), bounds.high.x(), bounds.high.y(), bounds.low.x()};
    const Vec2 size = bounds.high - bounds.low;
    for (int corner = 0; corner < 4; ++corner) {
      Walls start;
      double least_start = std::numeric_limits<double>::infinity();
      for (double x = 0.2; x < 0.85; x += 0.1) {
        for (double y = 0.2; y < 0.85; y += 0.1) {
          const Walls walls = notched(outer, corner, Vec2(x, y).cwiseProduct(size));
          const double error = meanSquare(walls, own);
          if (error >= least_start) continue;
          least_start = error;
          start = walls;
        }
      }
      const Walls walls = settled(start, own);
      const double error = meanSquare(walls, own);
      if (error >= least) continue;
      Polygon corners = cornersOf(walls);
      bool notch_is_clear = true;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 wall = corners[(i + 1) % corners.size()] - corners[i];
        notch_is_clear &= wall.norm() >= kLeastNotch * (i % 2 == 0 ? size.x() : size.y());
      }
      if (!notch_is_clear || !isSimple(corners) || signedArea(corners) <= 0.0) continue;
      for (Vec2& point : corners) point = Pose2{0.0, 0.0, heading}.toOuter(point);
      least = error;
      best = corners;
    }
  }
  return best;
}

}  // namespace handmap
