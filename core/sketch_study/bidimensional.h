// Bidimensional regression (Tobler 1994; Friedman & Kohler 2003): how alike two sets of places are,
// whatever the shift, turn and scale between them. The page of this room tells what each figure is.
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose2.h"

namespace handmap {

/// Euclidean: shift, turn and one scale. Affine: two scales and a shear.
enum class Transformation { Euclidean, Affine };

/// Whether a fit tells more than chance, or one more than another.
struct FitTest {
  double f = 0.0;
  int model_df = 0;
  int residual_df = 0;
  double p = 1.0;    ///< of an F at least so large by chance
  double aic = 0.0;  ///< less that of what it is held against: negative where the fit is better
};

/// dependent = shift + linear · independent.
struct BidimensionalFit {
  Transformation transformation = Transformation::Euclidean;
  int points = 0;
  Vec2 shift = Vec2::Zero();
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  double r_squared = 0.0;
  double distortion = 0.0;      ///< D: root of the summed squares that are left, dependent units
  double max_distortion = 0.0;  ///< D_max: the same of the dependent places about their mean

  Vec2 apply(const Vec2& independent) const { return shift + linear * independent; }
  double r() const;
  double distortionIndex() const;  ///< DI = D / D_max, 0 … 1
  /// linear = turn by theta · [scaleX, shear · scaleY; 0, scaleY].
  double theta() const;  ///< radians, counter-clockwise
  double scaleX() const;
  double scaleY() const;
  double shear() const;
  FitTest test() const;  ///< against no relation at all
};

/// nullopt where there are too few places for a residual (3, affine 4), or they coincide.
std::optional<BidimensionalFit> bidimensionalRegression(const std::vector<Vec2>& independent,
                                                        const std::vector<Vec2>& dependent,
                                                        Transformation transformation);

FitTest testOf(Transformation transformation, double r_squared, int points);
/// What the affine fit of the same places tells beyond the Euclidean one.
FitTest testAgainst(const BidimensionalFit& euclidean, const BidimensionalFit& affine);

}  // namespace handmap
