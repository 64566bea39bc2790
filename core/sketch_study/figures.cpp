#include "core/sketch_study/figures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace handmap {

namespace {

/// To six digits, never "-0".
std::string number(double value) { return fmt::format("{:.6g}", value + 0.0); }

class Names {
 public:
  void text(const std::string& name, const std::string& value) { all_.push_back({name, value}); }
  void count(const std::string& name, int value) { text(name, std::to_string(value)); }
  void add(const std::string& name, double value) { text(name, number(value)); }
  std::vector<NamedFigure> take() { return std::move(all_); }

 private:
  std::vector<NamedFigure> all_;
};

/// Empty values where too few places tell nothing.
void addFit(Names& names, const std::string& kind, const std::optional<BidimensionalFit>& fit) {
  using Fit = BidimensionalFit;
  const auto add = [&](const std::string& name, auto value) {
    names.text(fmt::format("{}_{}", kind, name), fit ? number(value(*fit)) : std::string());
  };
  add("r", [](const Fit& f) { return f.r(); });
  add("r_squared", [](const Fit& f) { return f.r_squared; });
  add("theta_deg", [](const Fit& f) { return toDegrees(f.theta()); });
  add("scale_x", [](const Fit& f) { return f.scaleX(); });
  add("scale_y", [](const Fit& f) { return f.scaleY(); });
  add("shear", [](const Fit& f) { return f.shear(); });
  add("shift_x_m", [](const Fit& f) { return f.shift.x(); });
  add("shift_y_m", [](const Fit& f) { return f.shift.y(); });
  add("distortion_m", [](const Fit& f) { return f.distortion; });
  add("max_distortion_m", [](const Fit& f) { return f.max_distortion; });
  add("distortion_index", [](const Fit& f) { return f.distortionIndex(); });
  add("f", [](const Fit& f) { return f.test().f; });
  add("f_model_df", [](const Fit& f) { return double(f.test().model_df); });
  add("f_residual_df", [](const Fit& f) { return double(f.test().residual_df); });
  add("p", [](const Fit& f) { return f.test().p; });
  add("aic", [](const Fit& f) { return f.test().aic; });
}

void addPairwise(Names& names, const PairwiseMeasures& pairwise) {
  names.add("canonical_organisation_share", pairwise.canonical_organisation);
  names.add("canonical_organisation_sqrt", pairwise.organisationRoot());
  names.add("canonical_accuracy_share", pairwise.canonical_accuracy);
  names.add("canonical_accuracy_sqrt", pairwise.accuracyRoot());
  names.add("distance_accuracy_share", pairwise.distance_accuracy);
  names.add("scaling_bias_share", pairwise.scaling_bias);
  names.add("angle_accuracy_share", pairwise.angle_accuracy);
  names.add("rotational_bias_deg", toDegrees(pairwise.rotational_bias_rad));
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\n\r") == std::string::npos) return field;
  std::string text;
  for (const char c : field) text.append(c == '"' ? 2 : 1, c);
  return fmt::format("\"{}\"", text);
}

}  // namespace

SketchFigures figuresOf(const Sketch& sketch, const std::string& stage) {
  SketchFigures figures;
  figures.drawing = sketch.name;
  figures.stage = stage;
  figures.generalisation = sketch.generalisation;
  figures.extra = static_cast<int>(extrasOf(sketch).size());
  std::vector<Vec2> truth;
  std::vector<std::optional<Vec2>> drawn;
  std::vector<Vec2> from;
  std::vector<Vec2> to;
  int outlines = 0;
  for (const SketchPair& pair : pairsOf(sketch)) {
    truth.push_back(pair.place);
    drawn.push_back(pair.drawn);
    if (!pair.drawn) continue;
    from.push_back(pair.place);
    to.push_back(*pair.drawn);
    if (pair.drawn_outline.empty()) continue;
    ++outlines;
    figures.overlap += intersectionOverUnion(pair.outline, pair.drawn_outline);
  }
  figures.overlap /= std::max(1, outlines);
  figures.objects = static_cast<int>(truth.size());
  figures.drawn = static_cast<int>(from.size());
  figures.completeness = static_cast<double>(figures.drawn) / std::max(1, figures.objects);
  figures.euclidean = bidimensionalRegression(from, to, Transformation::Euclidean);
  figures.affine = bidimensionalRegression(from, to, Transformation::Affine);
  figures.pairwise = pairwiseMeasures(truth, drawn);
  return figures;
}

std::vector<NamedFigure> namedFigures(const SketchFigures& figures) {
  Names names;
  names.text("drawing", figures.drawing);
  names.text("stage", figures.stage);
  names.count("true_objects", figures.objects);
  names.count("drawn_objects", figures.drawn);
  names.count("missing", figures.objects - figures.drawn);
  names.count("extra", figures.extra);
  names.add("completeness_share", figures.completeness);
  names.count("amalgamated", figures.generalisation.amalgamated);
  names.count("abstracted", figures.generalisation.abstracted);
  names.count("collapsed", figures.generalisation.collapsed);
  names.add("mean_overlap_share", figures.overlap);
  addFit(names, "euclidean", figures.euclidean);
  addFit(names, "affine", figures.affine);
  std::optional<FitTest> better;
  if (figures.euclidean && figures.affine) {
    better = testAgainst(*figures.euclidean, *figures.affine);
  }
  names.text("affine_better_f", better ? number(better->f) : "");
  names.text("affine_better_p", better ? number(better->p) : "");
  names.text("affine_better_aic", better ? number(better->aic) : "");
  addPairwise(names, figures.pairwise);
  return names.take();
}

std::string figureTable(const std::vector<SketchFigures>& rows) {
  std::string table;
  for (const SketchFigures& row : rows) {
    const std::vector<NamedFigure> figures = namedFigures(row);
    std::vector<std::string> names;
    std::vector<std::string> values;
    for (const NamedFigure& figure : figures) {
      names.push_back(figure.name);
      values.push_back(quoted(figure.value));
    }
    if (table.empty()) table = fmt::format("{}\n", fmt::join(names, ","));
    table += fmt::format("{}\n", fmt::join(values, ","));
  }
  return table;
}

}  // namespace handmap
