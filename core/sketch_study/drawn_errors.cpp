#include "core/sketch_study/drawn_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/sketch_study/bidimensional.h"
#include "core/sketch_study/pairwise.h"

namespace handmap {

namespace {

constexpr double kRightWithin = toRadians(10.0);  // what a hand draws as a right angle
constexpr double kQuarter = kPi / 2.0;
constexpr double kLeastFreedom = 0.05;  // a place that the fit follows tells next to nothing

int rightCornersOf(const Polygon& outline) {
  int right = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 in = outline[i] - outline[(i + outline.size() - 1) % outline.size()];
    const Vec2 out = outline[(i + 1) % outline.size()] - outline[i];
    const double angle = std::atan2(std::abs(cross(in, out)), in.dot(out));
    if (std::abs(angle - kQuarter) < kRightWithin) ++right;
  }
  return right;
}

double headingOf(const Polygon& outline) {
  Building building;
  building.shape = outline;
  return building.box().heading;
}

double sizeOf(const Polygon& outline) { return std::sqrt(std::abs(signedArea(outline))); }

void measureOutline(const SketchPair& pair, const BidimensionalFit& fit, DrawnError& error) {
  if (pair.outline.empty()) return;
  error.size = sizeOf(pair.outline);
  if (pair.drawn_outline.empty()) return;
  error.log_size = std::log(sizeOf(pair.drawn_outline) / fit.scaleX() / error.size);
  const double turn = headingOf(pair.drawn_outline) - fit.theta() - headingOf(pair.outline);
  error.turn = std::remainder(turn, kQuarter);
  error.corners = static_cast<int>(pair.drawn_outline.size());
  error.right_corners = rightCornersOf(pair.drawn_outline);
  error.true_corners = static_cast<int>(pair.outline.size());
  error.true_right_corners = rightCornersOf(pair.outline);
}

struct Places {
  std::vector<Vec2> truth;
  std::vector<Vec2> drawn;
  Vec2 middle = Vec2::Zero();  ///< of the true ones
  double spread = 0.0;         ///< their summed squares about it

  /// Of the least squares fit: how much place j draws the fit at place i.
  double leverage(std::size_t i, std::size_t j) const {
    return 1.0 / static_cast<double>(truth.size()) +
           (truth[i] - middle).dot(truth[j] - middle) / spread;
  }
};

void relateToNearest(const Places& places, DrawnErrors& errors) {
  for (std::size_t i = 0; i < errors.of.size(); ++i) {
    DrawnError& error = errors.of[i];
    error.freedom = 1.0 - places.leverage(i, i);
    error.nearest = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < errors.of.size(); ++j) {
      const double distance = (places.truth[i] - places.truth[j]).norm();
      if (i == j || distance >= error.nearest) continue;
      error.nearest = distance;
      error.off_product = error.off.dot(errors.of[j].off) / 2.0;
      error.product_loss = places.leverage(i, j);
    }
  }
}

double orderKept(const Places& places, double turn) {
  std::vector<std::optional<Vec2>> upright;
  const Pose2 back{0.0, 0.0, -turn};
  for (const Vec2& place : places.drawn) upright.emplace_back(back.toOuter(place));
  return pairwiseMeasures(places.truth, upright).canonical_accuracy;
}

}  // namespace

Vec2 DrawnError::fullOff() const { return off / std::sqrt(std::max(freedom, kLeastFreedom)); }

std::optional<DrawnErrors> drawnErrors(const Sketch& sketch) {
  const std::vector<SketchPair> pairs = pairsOf(sketch);
  Places places;
  for (const SketchPair& pair : pairs) {
    if (!pair.drawn) continue;
    places.truth.push_back(pair.place);
    places.drawn.push_back(*pair.drawn);
  }
  const auto fit = bidimensionalRegression(places.truth, places.drawn, Transformation::Euclidean);
  if (!fit) return std::nullopt;
  DrawnErrors errors;
  errors.name = sketch.name;
  errors.scale = fit->scaleX();
  errors.turn = fit->theta();
  errors.objects = static_cast<int>(pairs.size());
  errors.represented =
      fit->points + sketch.generalisation.amalgamated + sketch.generalisation.abstracted;
  errors.order_kept = orderKept(places, errors.turn);
  for (const Vec2& place : places.truth) places.middle += place / fit->points;
  for (const Vec2& place : places.truth) places.spread += (place - places.middle).squaredNorm();
  errors.extent = std::sqrt(places.spread / (2.0 * fit->points));
  const Eigen::Matrix2d back = fit->linear.inverse();
  for (const SketchPair& pair : pairs) {
    if (!pair.drawn) continue;
    DrawnError error;
    error.off = back * (*pair.drawn - fit->apply(pair.place));
    measureOutline(pair, *fit, error);
    errors.of.push_back(error);
  }
  relateToNearest(places, errors);
  return errors;
}

}  // namespace handmap
