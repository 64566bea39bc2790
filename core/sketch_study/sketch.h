// A drawing beside the true map, as sketch-map research compares them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace handmap {

/// How often several or large things were drawn as less (Schwering et al.: SketchMapia), of
/// buildings alone.
struct Generalisation {
  int amalgamated = 0;  ///< true buildings that were drawn as one with others
  int abstracted =
      0;  ///< true buildings that a few drawn ones stand for, to show that some are there
  int collapsed = 0;  ///< true buildings drawn as a point
  bool operator==(const Generalisation&) const = default;
};

/// What both maps have bears the same id: a building, a landmark, or a building that is drawn as a
/// landmark.
struct Sketch {
  std::string name;
  Map drawing;
  Map truth;
  Generalisation generalisation;
};

/// One object of the truth, and how it was drawn.
struct SketchPair {
  std::string id;
  Vec2 place = Vec2::Zero();  ///< of the truth: the centroid
  Polygon outline;            ///< of the truth; empty: a landmark
  std::optional<Vec2> drawn;  ///< nullopt: it is missing
  Polygon drawn_outline;      ///< empty: missing, or drawn as a point
};

/// All objects of the truth, in its order.
std::vector<SketchPair> pairsOf(const Sketch& sketch);
/// Ids of buildings and landmarks that are drawn and not there.
std::vector<std::string> extrasOf(const Sketch& sketch);

/// Counts what was amalgamated.
Sketch sketchOf(std::string name, Map drawing, Map truth);

/// A `.handmap` drawing and its true map, or, where both are `.geojson`, a sketch map in plane
/// coordinates with SketchMapia's `alignment.json` beside it. `metres` a unit of the true map.
/// Throws BadInput, also where nothing that is drawn is in the truth.
Sketch readSketch(const std::filesystem::path& drawing, const std::filesystem::path& truth,
                  double metres = 1.0);

/// The SketchMapia form. Where the picture lies beside a file its shape is undone: their canvas is
/// 850 by 600 whatever the picture is.
Sketch readAlignedSketch(const std::filesystem::path& drawing, const std::filesystem::path& truth,
                         double metres);

}  // namespace handmap
