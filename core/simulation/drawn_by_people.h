// Drawings with the errors that people's drawings have.
#pragma once

#include "core/simulation/world.h"

namespace handmap {

/// As `handmap-cli sketch-stats` finds it in six people's drawings of Münster; the page of
/// core/sketch_study has the intervals. Lengths are shares of the extent: σ of the coordinates of
/// the true buildings.
struct PeopleErrors {
  double position = 0.23;  ///< σ of a coordinate, once the whole is shifted, turned and scaled best
  /// Of the correlation exp(-distance / reach) of two errors: 0.26 of neighbours 0.76 apart.
  double reach = 0.57;
  double size_slope = 0.73;       ///< of ln drawn over ln true size: pulled to the mean
  double size_sigma = 0.25;       ///< σ of ln size about that
  double turn = toRadians(15.0);  ///< σ of an outline
  double missing = 0.2;           ///< 5 of 24 in both drawings of the second place
  static constexpr std::size_t kLeast =
      3;  ///< as many buildings are drawn, however many are missed
};

/// Every building is drawn as a rectangle (people draw five corners for sixteen) of the area that
/// follows; some are missing. Otherwise as perturbed(), and the drawing says what σ it has. The
/// scale is right: paper has none, so the drawings do not tell how wrong people are about it.
Map drawnByPeople(const Map& truth, const PeopleErrors& errors, std::uint64_t seed,
                  Keeping keeping = Keeping::SideAndOrder);

/// What a drawing that people made is off by, one σ, as far as the drawing itself tells.
Uncertainty uncertaintyOfPeople(const Map& drawing, const PeopleErrors& errors = {});

/// σ of the coordinates of the buildings, metres.
double extentOf(const Map& map);

}  // namespace handmap
