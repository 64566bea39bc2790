#include "core/sketching/stroke_recognition.h"

#include <gtest/gtest.h>

#include "tests/core/sketching/strokes.h"

namespace handmap {
namespace {

constexpr double kResolution = 0.2;

Polygon turnedBy(Polygon polygon, double heading) {
  for (Vec2& corner : polygon) corner = Pose2{30.0, -12.0, heading}.toOuter(corner);
  return polygon;
}

Polygon lShape(double width, double depth, double notch_x, double notch_y) {
  return {{0, 0},
          {width, 0},
          {width, depth - notch_y},
          {width - notch_x, depth - notch_y},
          {width - notch_x, depth},
          {0, depth}};
}

struct Tried {
  int first = 0;  ///< the right kind is the first guess
  int among = 0;  ///< it is one of them
  int of = 0;
  double overlap = 1.0;  ///< the least of those that were right
};

/// Draws each outline with many hands.
Tried tried(const std::vector<Polygon>& outlines, StrokeShape kind, const Hand& like) {
  Tried result;
  RandomStream random(7, 0, 0);
  for (int round = 0; round < 12; ++round) {
    for (const Polygon& outline : outlines) {
      Hand hand = like;
      hand.overlap = random.uniform(-0.04, 0.06);
      const Polygon meant = turnedBy(outline, random.uniform(-kPi, kPi));
      const auto guesses = recognizedShapes(strokeAlong(meant, hand, random), kResolution);
      ++result.of;
      const auto found = std::ranges::find(guesses, kind, &ShapeGuess::kind);
      if (found == guesses.end()) continue;
      ++result.among;
      if (found != guesses.begin()) continue;
      ++result.first;
      result.overlap = std::min(result.overlap, intersectionOverUnion(found->outline, meant));
    }
  }
  return result;
}

const std::vector<Polygon> kRectangles = {
    Rectangle{{0, 0}, 40, 15, 0}.corners(), Rectangle{{0, 0}, 20, 20, 0}.corners(),
    Rectangle{{0, 0}, 60, 10, 0}.corners(), Rectangle{{0, 0}, 12, 9, 0}.corners()};
const std::vector<Polygon> kLShapes = {lShape(40, 30, 20, 15), lShape(30, 30, 20, 18),
                                       lShape(50, 20, 20, 8), lShape(24, 40, 10, 20)};
const std::vector<Polygon> kPolygons = {
    {{0, 0}, {40, 0}, {20, 35}},
    {{0, 0}, {50, 0}, {35, 25}, {15, 25}},
    {{20, 0}, {40, 12}, {33, 36}, {7, 36}, {0, 12}},
    {{0, 0}, {40, 0}, {40, 30}, {28, 30}, {28, 10}, {12, 10}, {12, 30}, {0, 30}}};

TEST(StrokeRecognition, CarefulHandsAreAlwaysUnderstood) {
  const Hand hand{.wobble = 0.004, .jitter = 0.001, .rounding = 0.008};
  for (const auto& [outlines, kind] :
       {std::pair(kRectangles, StrokeShape::Rectangular), std::pair(kLShapes, StrokeShape::LShaped),
        std::pair(kPolygons, StrokeShape::Polygonal)}) {
    const Tried result = tried(outlines, kind, hand);
    EXPECT_GE(result.first, result.of - 2) << "kind " << static_cast<int>(kind);
    EXPECT_GT(result.overlap, 0.92) << "kind " << static_cast<int>(kind);
  }
}

TEST(StrokeRecognition, HastyHandsAreMostlyUnderstood) {
  const Hand hand{.wobble = 0.014, .jitter = 0.003, .rounding = 0.025};
  for (const auto& [outlines, kind] :
       {std::pair(kRectangles, StrokeShape::Rectangular), std::pair(kLShapes, StrokeShape::LShaped),
        std::pair(kPolygons, StrokeShape::Polygonal)}) {
    const Tried result = tried(outlines, kind, hand);
    EXPECT_GE(result.first, result.of * 85 / 100) << "kind " << static_cast<int>(kind);
    EXPECT_GE(result.among, result.of * 98 / 100) << "kind " << static_cast<int>(kind);
    EXPECT_GT(result.overlap, 0.75) << "kind " << static_cast<int>(kind);
  }
}

TEST(StrokeRecognition, EveryGuessIsABuilding) {
  RandomStream random(3, 0, 0);
  for (int round = 0; round < 60; ++round) {
    Polygon scribble;
    for (int i = 0; i < 60; ++i)
      scribble.emplace_back(random.uniform(0.0, 40.0), random.uniform(0.0, 40.0));
    for (const ShapeGuess& guess : recognizedShapes(scribble, kResolution)) {
      const Polygon& outline = guess.outline;
      EXPECT_TRUE(isSimple(outline));
      EXPECT_GT(signedArea(outline), 0.0);
      EXPECT_EQ(guess.kind == StrokeShape::Rectangular, guess.rectangle.corners() == outline);
      EXPECT_TRUE(std::isfinite(guess.misfit) && std::isfinite(guess.cost));
    }
    const Polygon outline = strokeOutline(scribble, kResolution);
    EXPECT_TRUE(outline.empty() || (isSimple(outline) && signedArea(outline) > 0.0));
  }
}

TEST(StrokeRecognition, LinesAndDotsAreNothing) {
  EXPECT_TRUE(recognizedShapes({}, kResolution).empty());
  EXPECT_TRUE(recognizedShapes(Polygon{{1, 1}, {1, 1}, {1, 1}}, kResolution).empty());
  Polygon line;
  for (int i = 0; i < 50; ++i) line.emplace_back(i, 0.3 * i);
  EXPECT_TRUE(recognizedShapes(line, kResolution).empty());
  const Polygon tiny{{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}};
  EXPECT_TRUE(recognizedShapes(tiny, kResolution).empty());
  EXPECT_TRUE(strokeOutline(line, kResolution).empty());
}

TEST(StrokeRecognition, TheStrokeItselfIsFollowed) {
  RandomStream random(5, 0, 0);
  const Polygon meant = lShape(40, 30, 20, 15);
  const Polygon outline = strokeOutline(strokeAlong(meant, {}, random), kResolution);
  EXPECT_GT(intersectionOverUnion(outline, meant), 0.9);
  EXPECT_GT(outline.size(), 6u);
}

}  // namespace
}  // namespace handmap
