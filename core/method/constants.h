// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/pose2.h"

namespace handmap::method {

// A conclusion.
inline constexpr double kMostlyRight = 0.6;   // 1; choice: of the buildings that were seen
inline constexpr double kFounded = 0.5;       // 1; derived: of what was found more stands than not
inline constexpr double kNearlyTrue_m = 1.0;  // m; choice: what found buildings are off
inline constexpr double kStretch_m = 20.0;    // m; choice: of way, between conclusions
inline constexpr double kStretchShare = 0.1;  // 1; choice: of the way, the same
inline constexpr int kRest = 2;               // 1; derived: of what one took, a third of a core

// What is stated of the pose, one σ.
inline constexpr double kWheelScale =
    0.05;  // 1; measured: robots of another simulator, 5 % too long
inline constexpr double kSigmaPerMetre =
    0.5;                                  // 1; derived: nine of ten within as far as it drove lost
inline constexpr double kLeast_m = 0.01;  // m; limit: less is rounding
inline constexpr double kLeastVariance = 1e-6;  // m²; limit: also rad², what is held absolutely

// What is said of it.
inline constexpr std::array<double, 3> kWithin_m = {1.0, 2.0, 5.0};  // m; choice: of a probability
inline constexpr double kHowOften = 0.9;                             // 1; choice: of a radius
inline constexpr double kHeadingSigmas = 1.645;  // σ; derived: kHowOften, to both sides
inline constexpr double kSureWithin_m = 1.5;     // m; choice: what a person would call so
inline constexpr double kRoughWithin_m = kWithin_m.back();  // m; derived: the same
inline constexpr double kSureHeading = toRadians(15.0);     // rad; choice: the same
inline constexpr std::size_t kSwarmMembers = 20;            // 1; choice: samples of each building

// The integral of a Gaussian over a disc.
inline constexpr double kMostSigmas = 6.0;  // σ; limit: no more is beyond
inline constexpr int kIntegralSteps = 60;   // 1; choice: exact to 1e-3
inline constexpr int kHalvings = 12;        // 1; choice: of an interval as long as its end
inline constexpr double kFarthest_m = 1e6;  // m; limit: of a radius

// A start that is given later.
inline constexpr double kSaidLast = 1e9;  // χ²; limit: no kernel
inline constexpr int kMostSteps = 100;    // iterations; limit: it has settled before

// Whether a robot is where an earlier drive was, by what was seen there (campus, corner, simulated
// quarters; window and share together): of looks within 2 m of there 0 to 9 % are refuted, 90 to
// 98 % of those 20 m off and farther, the others among like houses.
inline constexpr double kAround_m = 5.0;  // m; choice: beyond, other things are in sight
inline constexpr double kRolled_m = 4.0;  // m; choice: since it was stopped
inline constexpr double kRolledTurn = toRadians(20);  // rad; choice: the same
inline constexpr double kSeenAgain = 0.65;            // 1; measured: of what its looks share
inline constexpr double kCarried_s = 60.0;  // s; choice: for so long nobody told where it went

// Whether walls are recognised. So counted, 30 right drives (a campus, a corner, a street, a
// boulevard, grids and rows of houses, a town) never came below -28 m, also in gaps of 400 m
// without a drawn wall; five wrong starts on the campus and two that looked the wrong way in a grid
// of houses ended at -99 m or less. Among like houses those that looked the right way, 30 to 141 m
// off, did not: they recognise what stands there.
inline constexpr int kLeastWalls = 10;           // returns; choice: of a look, fewer say nothing
inline constexpr int kLeastMet = 3;              // returns; choice: fewer are strays
inline constexpr double kLeastShare = 0.05;      // 1; measured: right drives have 0.1 to 1
inline constexpr double kMet = 2.0;              // m; measured: that a metre is worth, recognised
inline constexpr double kThrough = -1.0;         // m; measured: the same, looked through
inline constexpr double kNotDrawn = -0.125;      // m; measured: the same, nothing is drawn there
inline constexpr double kMost_m = 100.0;         // m; measured: that count for it
inline constexpr double kLost_m = 40.0;          // m; measured: that count against it
inline constexpr double kUnrecognised_m = 50.0;  // m; choice: less is not worth a word, a gap
// Nobody looks through the walls of a true map: none of 1,819 looks on right ones (the campus, the
// corner, a street, a grid) was through more of them than on, 13 and 44 % of those on the map of
// another place, where chance lets 9 and 30 % meet some.
inline constexpr double kTrueThrough = 8.0;  // 1; measured: so much more that is worth

// How probably a building is wrong: shares of those that were (overlap with the true one below 0.3,
// or a larger one with another) among those of which the same was said, in 114 runs to the middle
// and to the end: campus, corner and street with all their drawings, far rows, the laser of another
// simulator, and five simulated scenes. Of 1,017 of which nothing was said 13 were wrong.
inline constexpr double kProbablyWrong = 0.4;  // 1; measured: 36 of 88 not recognised, as many
                                               // where labels were sure as where not; 31 of 64 by
                                               // rays; for any reason 107 of 180, most simulated
inline constexpr double kSlight = 0.3;  // 1; measured: of labels, below none of 9 was wrong, both
                                        // above were, too few for a figure of their own

}  // namespace handmap::method
