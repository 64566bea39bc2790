// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>
#include <cstddef>

#include "core/estimation/walls/constants.h"

namespace handmap::buildings {

// What a box says of a ray.
inline constexpr float kWallSlack_m = 0.05F;  // m; choice: of a wall against the poses, across it
inline constexpr float kLeastCosine = 0.02F;  // cosine; choice: of a ray along the wall itself
inline constexpr double kRobotInside = -1e6;  // nats; limit: no rays tell as much
inline constexpr double kImpossible = -1e9;   // nats; limit: a box of no size, worse than that
inline constexpr std::size_t kStride = 2;     // rays; choice: every second one, twice
inline constexpr double kNear_m = 2.0;        // m; choice: what lies about a wall may be of it
inline constexpr double kFloor_m =
    0.3;  // m; measured: FIELD.md, σ of boxes, maps and poses of real places
inline constexpr double kChance_m = 60.0;  // m; choice: walls of other buildings are spread so

// Finding.
inline constexpr double kLeastScore = 40.0;     // nats; choice: less is no building
inline constexpr double kTypicalSize_m = 15.0;  // m; choice: of sides that nobody saw, a house
inline constexpr double kLeastSize_m = 2.5;     // m; choice: a garage
inline constexpr std::size_t kHeading = 4;  // index; derived: of a box's five parameters the last
inline constexpr double kParallel = toRadians(7.0);  // rad; choice: tilted rows and the box
inline constexpr double kAgreed_m =
    walls::kCell_m;  // m; derived: of the ends of a wall and its box
inline constexpr double kLeastGap_m = 2.0 * walls::kCell_m;  // m; derived: between two buildings
inline constexpr double kSeedStep_m = 1.5;  // m; choice: a search first looks at, of a new one
inline constexpr double kPieceStep_m = walls::kCell_m;  // m; derived: the same, of halves of a box
inline constexpr double kSettledStep_m = 0.1;   // m; choice: the same, of what was seen before
inline constexpr double kLeastStep_m = 0.04;    // m; choice: below the noise
inline constexpr int kTries = 4;                // steps; choice: one way, before the next parameter
inline constexpr int kMostSeeds = 3;            // walls; choice: an observation, so much time
inline constexpr std::size_t kMostRivals = 20;  // boxes; limit: of memory
inline constexpr double kPromising = 30.0;      // nats; choice: that a local search may bring
inline constexpr double kGain = 1.0;            // nats; choice: that a change must bring
inline constexpr double kTelling = 4.0;         // nats; choice: between kNear_m before and behind
inline constexpr double kCommonArea = 0.15;     // 1; choice: of the smaller of two, not both can be
inline constexpr double kAlike = 0.8;           // 1; choice: of the larger of two that are the same

// Where a building ends.
inline constexpr double kSideways_m = 2.5;        // m; choice: around the corner
inline constexpr double kWidest = 0.15;           // rad; choice: the same
inline constexpr double kNearest_m = 1.0;         // m; choice: the corner is seen from no nearer
inline constexpr double kMostSigma_m = 1.2;       // m; choice: what is known no better is not told
inline constexpr double kPoseSigma = 0.002;       // rad; choice: of a laser
inline constexpr double kGrazing = 0.03;          // cosine; choice: a flatter ray meets no wall
inline constexpr std::size_t kLeastBearings = 4;  // rays; choice: fewer have no best
inline constexpr double kFallen =
    0.05;  // 1; choice: of the best, the sum must fall off to both ends

// What is measured around buildings.
inline constexpr double kForgetting = 0.97;  // 1; choice: a key frame, 70 m
inline constexpr float kSteep = 0.5F;        // cosine; choice: no wall seen along itself
inline constexpr double kBin_m = 4.0;        // m; choice: of range, the noise hardly changes in it
inline constexpr std::size_t kBins = 16;     // 1; choice: to 64 m
inline constexpr double kLeastReturns = 60.0;       // returns; choice: of a bin, σ to 10 %
inline constexpr double kLeastInformation = 400.0;  // 1/m²; choice: 5 cm, as kWallSlack_m
inline constexpr double kLeastTogether = 5.0;       // walls; choice: that tell how they are off
inline constexpr double kLeastSystematic_m = 0.01;  // m; choice: plaster
inline constexpr double kMostSystematic_m = 0.2;    // m; choice: recesses
inline constexpr double kMuch = 0.3;      // 1; choice: of σ or a rate, evidence is worth no more
inline constexpr double kMuchBias = 0.1;  // σ; choice: the same
inline constexpr double kMuchDensity = 0.01;         // 1/m; choice: the same
inline constexpr std::array kCompared_m{8.0, 24.0};  // m; choice: where σ is compared
inline constexpr double kFirstLooked_m = 500.0;  // m; choice: that no clutter at first counts for
inline constexpr double kFirstBlocked = 10.0;    // rays; choice: that end early at first, a fifth
inline constexpr double kFirstRays = 50.0;       // rays; choice: of so many

}  // namespace handmap::buildings
