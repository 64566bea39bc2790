// How people draw: what several drawings of known places tell, with intervals, and how well that
// tells the next person's drawing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/sketch_study/drawn_errors.h"

namespace handmap {

/// After the best shift, turn and scale of each drawing. Sizes are roots of areas.
struct PeopleFigures {
  double position_m = 0.0;             ///< σ of a coordinate
  double position_of_extent = 0.0;     ///< the same as a share of the extent of the place
  double position_of_size = 0.0;       ///< the same as a share of the building's own size
  double bulk_of_extent = 0.0;         ///< scale of the t distribution that fits the shares
  double tail_freedom = 0.0;           ///< its degrees of freedom
  double neighbour_correlation = 0.0;  ///< of the errors of nearest neighbours
  double neighbour_distance = 0.0;     ///< their mean distance, a share of the extent
  double size_slope = 0.0;   ///< of ln drawn over ln true size: below 1 they are pulled to the mean
  double size_factor = 0.0;  ///< drawn / true in the scale of the places: below 1 gaps are too wide
  double size_sigma = 0.0;   ///< σ of ln size about that
  double size_m = 0.0;       ///< rms error of the size
  double turn_deg = 0.0;     ///< of outlines, to the next quarter: what 68 % are within
  double right_corners = 0.0;  ///< share of the drawn corners
  double true_right_corners = 0.0;
  double corners = 0.0;  ///< of an outline, mean
  double true_corners = 0.0;
  double order_kept = 0.0;        ///< of pairs, along both axes
  double missing = 0.0;           ///< of the true buildings, neither drawn nor in a group
  double drawing_turn_deg = 0.0;  ///< rms turn of whole drawings
  double drawing_scale = 0.0;     ///< σ of ln scale of whole drawings
};

/// A member of it, by its name in tables.
struct PeopleFigure {
  const char* name;
  double PeopleFigures::*value;
};
const std::vector<PeopleFigure>& allPeopleFigures();

PeopleFigures peopleFigures(const std::vector<DrawnErrors>& drawings);

struct FigureRange {
  double low = 0.0;
  double high = 0.0;
};
/// Of 95 %, in the order of allPeopleFigures(): persons are drawn again with replacement, and of
/// each the things that he drew.
std::vector<FigureRange> peopleIntervals(const std::vector<DrawnErrors>& drawings, int draws,
                                         std::uint64_t seed);

/// How well an account of the others' errors tells those of a person who was left out.
struct Foretold {
  const char* account;
  double within_68 = 0.0;  ///< share within what 68 % of the others' are
  double within_95 = 0.0;
  double normal_score = 0.0;  ///< mean log density of an error, per metre (sizes: of ln size)
  double heavy_score = 0.0;   ///< the same of a t distribution
};
/// Of coordinates: σ the same everywhere, or with the extent, or with the building's size.
std::vector<Foretold> foretellPlaces(const std::vector<DrawnErrors>& drawings);
/// Of ln sizes: as they are, times a factor, pulled to the mean.
std::vector<Foretold> foretellSizes(const std::vector<DrawnErrors>& drawings);

}  // namespace handmap
