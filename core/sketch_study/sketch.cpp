#include "core/sketch_study/sketch.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/map/map_io.h"
#include "core/sketch_study/bidimensional.h"

namespace handmap {

namespace {

/// True buildings that are missing and lie on a drawn one, once the drawing is laid upon the truth.
int amalgamatedIn(const std::vector<SketchPair>& pairs) {
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  for (const SketchPair& pair : pairs) {
    if (!pair.drawn) continue;
    from.push_back(pair.place);
    to.push_back(*pair.drawn);
  }
  const auto fit = bidimensionalRegression(from, to, Transformation::Euclidean);
  if (!fit) return 0;
  return static_cast<int>(std::ranges::count_if(pairs, [&](const SketchPair& missing) {
    return !missing.drawn && !missing.outline.empty() &&
           std::ranges::any_of(pairs, [&](const SketchPair& other) {
             return !other.drawn_outline.empty() &&
                    contains(other.drawn_outline, fit->apply(missing.place));
           });
  }));
}

}  // namespace

std::vector<SketchPair> pairsOf(const Sketch& sketch) {
  const auto drawnAs = [&](SketchPair& pair) {
    if (const Building* building = sketch.drawing.find(pair.id)) {
      const Polygon outline = building->footprint();
      pair.drawn = centroid(outline);
      if (!pair.outline.empty()) pair.drawn_outline = outline;
      return;
    }
    const auto& landmarks = sketch.drawing.landmarks;
    const auto found = std::ranges::find(landmarks, pair.id, &Landmark::id);
    if (found != landmarks.end()) pair.drawn = found->position;
  };
  std::vector<SketchPair> pairs;
  for (const Building& building : sketch.truth.buildings) {
    const Polygon outline = building.footprint();
    pairs.push_back({building.id, centroid(outline), outline, std::nullopt, {}});
    drawnAs(pairs.back());
  }
  for (const Landmark& landmark : sketch.truth.landmarks) {
    pairs.push_back({landmark.id, landmark.position, {}, std::nullopt, {}});
    drawnAs(pairs.back());
  }
  return pairs;
}

std::vector<std::string> extrasOf(const Sketch& sketch) {
  std::vector<std::string> extras;
  const auto add = [&](const std::string& id) {
    const auto& landmarks = sketch.truth.landmarks;
    if (sketch.truth.find(id) == nullptr &&
        std::ranges::find(landmarks, id, &Landmark::id) == landmarks.end()) {
      extras.push_back(id);
    }
  };
  for (const Building& building : sketch.drawing.buildings) add(building.id);
  for (const Landmark& landmark : sketch.drawing.landmarks) add(landmark.id);
  return extras;
}

Sketch sketchOf(std::string name, Map drawing, Map truth) {
  Sketch sketch{std::move(name), std::move(drawing), std::move(truth), {}};
  sketch.generalisation.amalgamated = amalgamatedIn(pairsOf(sketch));
  return sketch;
}

Sketch readSketch(const std::filesystem::path& drawing, const std::filesystem::path& truth,
                  double metres) {
  const bool aligned = drawing.extension() == ".geojson";
  if (aligned != (truth.extension() == ".geojson")) {
    throwBadInput(truth.string(), "", "another kind of file than " + drawing.string(),
                  "both .handmap or both .geojson");
  }
  Sketch sketch = aligned ? readAlignedSketch(drawing, truth, metres)
                          : sketchOf(drawing.string(), readMap(drawing), readMap(truth));
  const std::vector<SketchPair> pairs = pairsOf(sketch);
  if (std::ranges::none_of(pairs, [](const SketchPair& pair) { return pair.drawn.has_value(); })) {
    throwBadInput(drawing.string(), "", "nothing that is in " + truth.string(), "the same ids");
  }
  return sketch;
}

}  // namespace handmap
