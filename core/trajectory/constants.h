// The numbers of the room, each with its unit and where it comes from. README.md says how they
// belong together.
#pragma once

#include <array>
#include <cstddef>

#include "core/odometry/constants.h"
#include "core/perception/constants.h"

namespace handmap::trajectory {

// What can be used of the returns.
inline constexpr double kLeastStraight = 0.1;  // 1; measured: README, of the returns

// Straight pieces.
inline constexpr int kNeighbours = 6;        // returns; measured: FIELD.md (a), on either side
inline constexpr int kLeastPoints = 5;       // returns; choice: two parameters and some to judge by
inline constexpr double kGapSpacings = 4.5;  // 1; measured: FIELD.md (a), a wall seen at 13°
inline constexpr double kRough_m = 0.08;     // m; measured: FIELD.md (a), plaster, window frames
inline constexpr double kRoughPerMetre = 0.002;  // 1; measured: FIELD.md (a), with the range
inline constexpr double kLeastLength = 5.0;      // thicknesses; measured: FIELD.md (a)
inline constexpr double kNoisy = 1.5;  // 1; choice: of the noise, what a piece may be thick
inline constexpr double kStandingCell_m = 0.35;  // m; choice: a piece is three of them wide

// The noise of ranges, as a histogram of what returns are off.
inline constexpr double kBin_m = 10.0;       // m; choice: of range
inline constexpr std::size_t kRanges = 8;    // bins; choice: to 80 m and beyond
inline constexpr int kLeastCount = 100;      // returns; choice: their median is off by a tenth
inline constexpr double kLeastOff_m = 1e-3;  // m; choice: where the histogram begins
inline constexpr std::size_t kStepsPerDecade = 15;          // 1; choice: of 17 % each
inline constexpr std::size_t kSteps = 4 * kStepsPerDecade;  // 1; derived: to 10 m
inline constexpr double kLeastNoise_m = 0.01;               // m; choice: data sheets of lasers

// A scan laid on a map.
inline constexpr double kCell_m = 0.5;             // m; measured: FIELD.md (a) and (b)
inline constexpr double kNear_m = kCell_m / 2.0;   // m; derived: what is as near is explained
inline constexpr int kSide = 256;                  // cells; choice: twice what a scan reaches, 64 m
inline constexpr std::ptrdiff_t kMostOfAKind = 8;  // points; choice: in a cell, every 6 cm of wall
inline constexpr std::array kGates_m{1.5, 1.0, 0.7, 0.5, 0.5};  // m; measured: FIELD.md (a)
inline constexpr double kPoint_m = 0.2;  // m; choice: σ about a point of a bush, but for noise
inline constexpr double kShared = 0.4;   // 1; measured: FIELD.md (a), neighbours are off together
inline constexpr double kKernelGates = 0.3;  // gates; measured: FIELD.md (a), Cauchy's kernel bends
inline constexpr std::size_t kMostScanPoints = 400;  // points; choice: more tell the same
inline constexpr int kMatchSteps = 4;     // iterations; measured: FIELD.md (a), for each gate
inline constexpr double kStill_m = 1e-3;  // m; limit: of a step, a hundredth of a return
inline constexpr double kStill = 1e-4;    // rad; limit: the same at 10 m

// Odometry by scans.
inline constexpr double kWindow_m = 100.0;   // m; choice: of way, the rest is out of sight
inline constexpr double kKeep_m = 0.8;       // m; measured: FIELD.md (a), between scans of the map
inline constexpr int kLeastMatched = 20;     // returns; measured: FIELD.md (a)
inline constexpr double kTurnSigmas = 3.0;   // σ; measured: FIELD.md (a), more is a wrong match
inline constexpr double kMoveSquare = 18.0;  // σ²; measured: FIELD.md (a), the same
inline constexpr double kExplained = 0.7;  // 1; choice: of straight returns, no turn is looked for
inline constexpr std::array kOtherTurns{0.12, -0.12, 0.25, -0.25, 0.4,
                                        -0.4, 0.6,   -0.6};  // rad; choice: a robot's, in a second
inline constexpr double kStraysIn_m = 1.0;  // m; measured: README, of way, a match's own variance
inline constexpr double kHeld = 1.5;  // 1; measured: README, times chance, two walls have 1.43
inline constexpr double kMostOfBefore = 3.0;  // 1; choice: of a motion, speed does not last longer
inline constexpr double kWorthAWord_m = 0.5;  // m; choice: that a guess may be off
inline constexpr double kClearlySharper = 0.015;  // 1; measured: FIELD.md's part 2, 3, is chance

// Points that were followed, a look at one (half and double tell the same way).
inline constexpr double kLookBearing = 0.0015;           // rad; choice: a pixel, measured 0.0005
inline constexpr double kLookInverseRange_per_m = 4e-4;  // 1/m; measured: README of simulation
inline constexpr std::array kLookKernels{1000.0, 30.0, 3.0};  // χ²; choice: odometry may slip

// How wheels err, and guesses.
inline constexpr std::size_t kDeviations = 80;       // motions; measured: FIELD.md (a)
inline constexpr std::size_t kLeastDeviations = 10;  // motions; choice: σ to a quarter
inline constexpr std::size_t kRatios = 300;          // motions; measured: FIELD.md (a)
inline constexpr std::size_t kLeastRatios = 40;      // motions; choice: a length to half a per cent
inline constexpr double kPulled =
    1.6 * 1.48;  // 1; measured: FIELD.md (a), σ by a median, and a match is pulled by its prior
inline constexpr double kLeastScale = 2.0;          // 1; measured: README, of σ, and at first
inline constexpr double kLeastScaleFollowed = 0.7;  // 1; measured: FIELD.md (a), of σ
inline constexpr double kMostMoveScale = 4.0;       // 1; measured: FIELD.md (a), of σ
inline constexpr double kMostTurnScale = 6.0;       // 1; measured: FIELD.md (a), of σ
// As measured on a campus and in simulated quarters, scans a metre apart: within a third of each
// the way is off by a tenth to a quarter of what it is with three times as much.
inline constexpr double kGuessedMove = 10.0;   // 1; measured: 0.1 m and 30 %, it keeps its speed
inline constexpr double kGuessedAside = 3.0;   // 1; measured: 0.03 m and 3 %, where it looks
inline constexpr double kGuessedTurn = 150.0;  // 1; measured: 9° and more the farther
inline constexpr double kLeastNoise =
    0.1;  // 1; choice: of the odometry's, a scan may be off itself

// Keyframes and their graph.
inline constexpr double kKeyframe_m = 1.8;   // m; measured: FIELD.md (b)
inline constexpr double kKernel = 9.0;       // χ²; measured: FIELD.md (b), odometry may slip
inline constexpr double kLoopKernel = 30.0;  // χ²; measured: FIELD.md (b), far off at first

// Loops.
inline constexpr std::size_t kSourceReach = 6;  // keyframes; measured: FIELD.md (b), either side
inline constexpr double kApart_m = 80.0;   // m; measured: FIELD.md (b), of way, nearer is no loop
inline constexpr double kPassing_m = 6.0;  // m; measured: FIELD.md (b), two lanes
inline constexpr double kShift_m = 2.5;    // m; measured: FIELD.md (b), is searched, is elsewhere
inline constexpr double kMostShift_m = 12.0;     // m; measured: FIELD.md (b)
inline constexpr double kTurn = 0.06;            // rad; measured: FIELD.md (b), is searched
inline constexpr double kTurnPerMetre = 0.0002;  // rad/m; measured: FIELD.md (b)
inline constexpr double kMostTurn = 0.22;        // rad; measured: FIELD.md (b)
inline constexpr double kTurnStep = 0.02;        // rad; derived: kCell_m at 25 m
inline constexpr double kOtherTurn = 0.09;       // rad; measured: FIELD.md (b), is elsewhere
inline constexpr double kMostOther = 0.85;  // 1; measured: FIELD.md (b), of the best place's hits
inline constexpr std::size_t kMostSubmapPoints = 250;  // points; choice: more tell the same
inline constexpr double kFaceReach = 0.5;  // cosine; choice: a piece at 45° to two ways is both
inline constexpr std::array kLoopGates_m{1.0, 0.7, 0.5, 0.4};  // m; choice: the search was coarse
inline constexpr double kLeastShare = 0.45;       // 1; measured: FIELD.md (b), of straight returns
inline constexpr double kLeastFollowed = 0.2;     // 1; measured: README, of followed points
inline constexpr int kLeastNear = 60;             // returns; measured: FIELD.md (b)
inline constexpr double kLeastEigenRatio = 0.04;  // 1; measured: FIELD.md (b), not a corridor
inline constexpr double kTogether = 0.02;     // 1; measured: FIELD.md (b), of independent returns
inline constexpr double kFloorTurn = 0.0045;  // rad; measured: FIELD.md (b)
inline constexpr std::size_t kMostPoints = 2'000'000;  // points; limit: 80 MB, 4 km of a scanner

// Sharpness.
inline constexpr double kSharpnessCell_m = 2.0;   // m; measured: FIELD.md's part 2, 3 (Q)
inline constexpr double kRound_m2 = 0.02;         // m²; measured: Q, of the spacing of returns
inline constexpr double kMostSquare = 16.0;       // σ²; measured: Q, farther adds nothing
inline constexpr double kBackground = 0.001;      // 1/m²; measured: Q, density where nothing is
inline constexpr int kSamples = 6000;             // returns; measured: Q
inline constexpr int kRoughSamples = 2000;        // returns; choice: is it usable at all
inline constexpr double kElsewhere_m = 4.0;       // m; measured: Q, of way between two looks
inline constexpr double kSharpRange_m = 38.0;     // m; measured: Q, far rows
inline constexpr double kSharpShare = 0.95;       // 1; choice: of the range limit, files round it
inline constexpr std::size_t kSharpPoints = 100;  // returns; choice: of a frame
inline constexpr double kLook_m = 1.0;            // m; measured: Q, between frames
inline constexpr std::size_t kMostSeen = 1'000'000;  // returns; limit: 24 MB
inline constexpr std::size_t kFirstJudged = 20;      // observations; choice: fewer tell nothing
inline constexpr std::size_t kJudgedAnew = 4;        // 1; choice: with a quarter more

}  // namespace handmap::trajectory
