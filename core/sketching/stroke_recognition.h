// What a person meant by a freehand stroke around a building.
//
// The stroke is closed (an overshoot is cut off), sampled evenly, and three families of outlines
// are fitted to it: a rectangle, a rectangle without one of its corners (an L), and polygons, with
// right angles and without. Each is judged by
//   N ln(r² + f²) + c k
// with r the rms distance between stroke and outline both ways, k the numbers that describe the
// outline, f the wobble of a hand and N the stroke's independent points, so that a simpler outline
// wins until the stroke contradicts it.
#pragma once

#include <span>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

enum class StrokeShape { Rectangular, LShaped, Polygonal };

struct ShapeGuess {
  StrokeShape kind = StrokeShape::Polygonal;
  Polygon outline;           ///< simple and counter-clockwise
  Rectangle rectangle = {};  ///< the outline, where the kind is Rectangular
  double misfit = 0.0;       ///< rms, metres
  double cost = 0.0;
};

/// The stroke as an outline with no more corners than it takes to follow it to `resolution` metres.
/// Empty where the stroke encloses nothing.
Polygon strokeOutline(std::span<const Vec2> stroke, double resolution);

/// The best guess first; none for a stroke that encloses nothing. `resolution`: below it (metres)
/// the stroke says nothing, such as the size of a pixel.
std::vector<ShapeGuess> recognizedShapes(std::span<const Vec2> stroke, double resolution);

}  // namespace handmap
