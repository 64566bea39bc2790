// All figures of a drawing against the truth, and their table.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sketch_study/bidimensional.h"
#include "core/sketch_study/pairwise.h"
#include "core/sketch_study/sketch.h"

namespace handmap {

/// The true places are the independent ones: a scale above 1 is a drawing that is too large.
struct SketchFigures {
  std::string drawing;
  std::string stage;  ///< "drawn" or "corrected"
  int objects = 0;    ///< of the truth: buildings and landmarks
  int drawn = 0;      ///< of them
  int extra = 0;      ///< drawn, and not there
  Generalisation generalisation;
  double completeness = 0.0;  ///< drawn / objects
  double overlap = 0.0;  ///< mean intersection over union of the buildings of both, as they lie
  std::optional<BidimensionalFit> euclidean;
  std::optional<BidimensionalFit> affine;
  PairwiseMeasures pairwise;
};

SketchFigures figuresOf(const Sketch& sketch, const std::string& stage = "drawn");

/// A figure by its name in the table, as it stands there; empty where it cannot be told.
struct NamedFigure {
  std::string name;  ///< with its unit: _m, _deg, _share; none: a plain number
  std::string value;
};
std::vector<NamedFigure> namedFigures(const SketchFigures& figures);

/// CSV (RFC 4180): a header, then a row a drawing.
std::string figureTable(const std::vector<SketchFigures>& rows);

}  // namespace handmap
