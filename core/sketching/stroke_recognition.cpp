#include "core/sketching/stroke_recognition.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/sketching/right_angled_fit.h"
#include "core/sketching/squaring.h"
#include "core/sketching/stroke.h"

namespace handmap {

namespace {

constexpr std::size_t kSamples = 160;
constexpr double kIndependentPoints = 24.0;
constexpr double kCostOfNumber = 2.5;
constexpr double kWobble = 0.012;           // of the diagonal
constexpr double kCornerTolerance = 0.045;  // of the diagonal: what stands out less is wobble
constexpr double kLeastTurn = toRadians(22.0);
constexpr double kLeastArea = 0.02;  // of the square of the diagonal: less is a line

Polygon counterClockwise(Polygon polygon) {
  if (signedArea(polygon) < 0.0) std::ranges::reverse(polygon);
  return polygon;
}

/// The line through the middle part of the samples between two corners: where it goes through, and
/// its way.
Segment lineThrough(const Polygon& samples, std::size_t first, std::size_t count) {
  const std::size_t margin = count / 6;
  Vec2 mean = Vec2::Zero();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  const auto used = static_cast<double>(count - 2 * margin);
  const auto sample = [&](std::size_t i) { return samples[(first + i) % samples.size()]; };
  for (std::size_t i = margin; i < count - margin; ++i) mean += sample(i) / used;
  for (std::size_t i = margin; i < count - margin; ++i)
    spread += (sample(i) - mean) * (sample(i) - mean).transpose();
  const double angle = 0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
  return {mean, mean + unitVector(angle)};
}

std::optional<Vec2> crossingOf(const Segment& a, const Segment& b) {
  const Vec2 along = a.b - a.a;
  const double sine = cross(along, b.b - b.a);
  if (std::abs(sine) < 0.2) return std::nullopt;
  return a.a + along * (cross(b.a - a.a, b.b - b.a) / sine);
}

/// Corners of the rough outline put where the walls between them meet.
Polygon sharpened(const Polygon& samples, const Polygon& rough, double reach) {
  const auto place = [&](const Vec2& corner) {
    return static_cast<std::size_t>(
        std::ranges::min_element(
            samples, {}, [&](const Vec2& sample) { return (sample - corner).squaredNorm(); }) -
        samples.begin());
  };
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    const std::size_t first = place(rough[i]);
    const std::size_t last = place(rough[(i + 1) % rough.size()]);
    const std::size_t count = (last + samples.size() - first) % samples.size();
    walls.push_back(count < 6 ? Segment{rough[i], rough[(i + 1) % rough.size()]}
                              : lineThrough(samples, first, count));
  }
  Polygon corners;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    const auto meeting = crossingOf(walls[(i + walls.size() - 1) % walls.size()], walls[i]);
    const bool near = meeting && (*meeting - rough[i]).norm() <= reach;
    corners.push_back(near ? *meeting : rough[i]);
  }
  return corners;
}

/// Without the corners at which the outline hardly turns.
Polygon withoutBends(Polygon polygon) {
  for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
    const Vec2& before = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Vec2& after = polygon[(i + 1) % polygon.size()];
    const Vec2 in = polygon[i] - before;
    const Vec2 out = after - polygon[i];
    const double turn = std::atan2(cross(in, out), in.dot(out));
    if (std::abs(turn) >= kLeastTurn) {
      ++i;
      continue;
    }
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;
  }
  return polygon;
}

class Judge {
 public:
  Judge(const Polygon& samples, double resolution)
      : samples_(samples), floor_(std::max(resolution, kWobble * diagonalOf(samples))) {}

  ShapeGuess judged(StrokeShape kind, Polygon outline, double numbers,
                    const Rectangle& rectangle = {}) const {
    const double misfit = misfitOf(samples_, outline);
    const double cost =
        kIndependentPoints * std::log(misfit * misfit + floor_ * floor_) + kCostOfNumber * numbers;
    return {kind, std::move(outline), rectangle, misfit, cost};
  }

 private:
  const Polygon& samples_;
  double floor_;
};

}  // namespace

Polygon strokeOutline(std::span<const Vec2> stroke, double resolution) {
  const Polygon closed = closedStroke(stroke);
  if (closed.empty()) return {};
  for (double tolerance = resolution; tolerance < diagonalOf(closed); tolerance *= 2.0) {
    Polygon outline = simplified(closed, tolerance);
    if (outline.size() >= 3 && isSimple(outline)) return counterClockwise(std::move(outline));
  }
  return {};
}

std::vector<ShapeGuess> recognizedShapes(std::span<const Vec2> stroke, double resolution) {
  const Polygon closed = closedStroke(stroke);
  if (closed.empty()) return {};
  const double diagonal = diagonalOf(closed);
  if (diagonal <= 3.0 * resolution ||
      std::abs(signedArea(closed)) < kLeastArea * diagonal * diagonal)
    return {};
  const Polygon samples = counterClockwise(evenlySampled(closed, kSamples));
  const Judge judge(samples, resolution);

  std::vector<ShapeGuess> guesses;
  const Rectangle rectangle = fittedRectangle(samples);
  guesses.push_back(judge.judged(StrokeShape::Rectangular, rectangle.corners(), 5.0, rectangle));
  if (const auto l_shape = fittedLShape(samples, rectangle))
    guesses.push_back(judge.judged(StrokeShape::LShaped, *l_shape, 7.0));

  const double tolerance = std::max(resolution, kCornerTolerance * diagonal);
  const Polygon rough = withoutBends(simplified(samples, tolerance));
  if (rough.size() >= 3) {
    const Polygon free = counterClockwise(sharpened(samples, rough, 2.5 * tolerance));
    if (isSimple(free)) {
      const auto corners = static_cast<double>(free.size());
      guesses.push_back(judge.judged(StrokeShape::Polygonal, free, 2.0 * corners));
      const auto squared = squaredUp(free);
      if (squared && squared->size() > 6)
        guesses.push_back(judge.judged(StrokeShape::Polygonal, *squared,
                                       static_cast<double>(squared->size()) + 1));
    }
  }
  std::ranges::stable_sort(guesses, {}, &ShapeGuess::cost);
  return guesses;
}

}  // namespace handmap
