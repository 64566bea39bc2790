// The numbers of the room, each with its unit and where it comes from. README.md says how they
// belong together.
#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/pose2.h"

namespace handmap::outlines {

// Seen frames.
inline constexpr double kFrameStep_m = 0.5;  // m; choice: between them, before any is thinned out
inline constexpr double kRaysPerMetre = 1000.0;  // rays; measured: structure needs no more
inline constexpr double kMostRays = 4000.0;      // rays; limit: of a frame, after a jump
inline constexpr float kLow_m = 0.5F;            // m; choice: above kerbs and what lies about
inline constexpr float kLeastRange_m = 0.5F;     // m; choice: nearer is the robot itself
inline constexpr std::size_t kBearings = 360;    // 1; choice: a degree each, a look tells one thing
inline constexpr double kSilent = 0.99;          // 1; choice: of the range limit, files round it

// Structure: what returns are from.
inline constexpr double kCell_m = 0.25;  // m; choice: as thick as a wall
inline constexpr int kReach = 5;         // cells; choice: 1.25 m, no longer than pieces of walls
inline constexpr double kLeastReturns = 12.0;    // returns; choice: two of each unknown of a line
inline constexpr double kLeastLength_m = 0.35;   // m; choice: σ along a piece of a metre
inline constexpr double kWall_m = 0.11;          // m; measured: recesses and poses, FIELD.md
inline constexpr double kWallNoise = 0.7;        // 1; measured: of the noise, left after weighing
inline constexpr double kHedge_m = 0.235;        // m; measured: FIELD.md
inline constexpr double kHedgeNoise = 1.2;       // 1; measured: FIELD.md
inline constexpr double kPoses_m2 = 0.02;        // m²; choice: variance of the poses, 0.14 m
inline constexpr double kNoiseBin_m = 5.0;       // m; choice: the noise hardly changes in it
inline constexpr std::size_t kNoiseBins = 7;     // 1; choice: up to 35 m, up to 60 m it is the same
inline constexpr std::size_t kLeastInBin = 100;  // returns; choice: their median is off by a tenth
inline constexpr double kNoiseCosine = 0.4;   // 1; choice: flatter rays tell nothing of the range
inline constexpr int kStructureRounds = 2;    // rounds; measured: the noise has settled
inline constexpr double kStand_m = 2.0;       // m; choice: from there things look the same
inline constexpr double kAway_m = 20.0;       // m; choice: of way, before it comes back
inline constexpr int kSectors = 24;           // 1; choice: 15° each
inline constexpr double kPlace_m = 0.5;       // m; choice: what ends in it is off together
inline constexpr float kEnoughLooks = 30.0F;  // looks; choice: three nats of a wall, kTemper
inline constexpr double kStructured = 0.1;    // 1; measured: of tall returns, between stereo's 0.05
                                              // and 0.15 of a real drive

// A ray that would meet a wall.
inline constexpr double kSlack_m = 0.15;  // m; choice: recesses and poses
inline constexpr double kStopped = 0.9;  // 1; measured: rays that a wall lets not through, FIELD.md
/// How often a return from a wall looks so, and how many others do along a metre.
struct Rates {
  double of_walls;
  double of_others;
};
/// By Likeness: straight and along the wall, straight and askew, linear and along it, ragged, low.
inline constexpr std::array<Rates, 5> kRates = {
    {{0.8, 0.02},
     {0.05, 0.1},
     {0.2, 0.06},
     {0.1, 0.1},
     {0.08, 0.1}}};                           // 1; measured: at true
                                              // poses on a residential drive and a campus
inline constexpr float kParallel = 0.92F;     // 1; choice: cosine, 23°, of what lies along a wall
inline constexpr float kLeastCosine = 0.1F;   // 1; choice: flatter rays tell as little
inline constexpr float kLeastRatio = 0.02F;   // 1/m; limit: of the table
inline constexpr float kMostRatio = 2000.0F;  // 1/m; limit: of the table
inline constexpr int kTableSteps = 64;        // 1; choice: of the table, an eighth of σ
inline constexpr double kTemper = 0.1;        // 1; choice: ten looks that share a pose are one
inline constexpr double kInside = 20.0;       // nats; choice: a frame, of a robot in a building
inline constexpr double kSilentNear = 0.12;   // 1; measured: silence from a wall, a campus
inline constexpr double kSilentFar = 0.35;    // 1; measured: its growth to the range limit
inline constexpr double kSeenReturns = 1.0;   // returns; choice: ten looks, of a side that was seen
inline constexpr int kNobody = -1;            // index; choice: of a return that is no building's
inline constexpr std::size_t kBlock = 128;    // rays; choice: of them at once, in a fast cache

// Where an outline may be.
inline constexpr double kMostScale = 0.3;             // 1; measured: logs of drawn sizes, METHOD.md
inline constexpr double kMostTurn = toRadians(15.0);  // rad; measured: core/sketch_study
inline constexpr double kMostShear = 0.03;        // 1; choice: walls stand upright on each other
inline constexpr double kLeastShare = 0.01;       // 1; choice: of sizes said to be exact
inline constexpr int kSamples = 4000;             // samples; measured: README, what hangs on them
inline constexpr std::size_t kAsked = 2500;       // rays; choice: samples are weighed by
inline constexpr std::size_t kAskedLater = 8000;  // rays; choice: those that are left, by
inline constexpr double kWidest = 2.5;            // σ; choice: of the prior that samples are from
inline constexpr double kMostSizeOff =
    kWidest * kMostScale;  // 1; derived: logs of sizes, beyond it is another thing
inline constexpr double kSlackAtFirst_m = 1.5;  // m; choice: so wide a wall is not missed
/// Of the search: how thick a wall is taken to be, how many places go on, how far it steps.
struct Stage {
  double slack_m;
  std::size_t tries;
  double step_m;
  double least_step_m;
};
inline constexpr std::array kStages{Stage{0.8, 24, 1.0, 0.3},
                                    Stage{0.3, 12, 0.5, 0.15}};  // m; choice: from coarse to fine
inline constexpr Stage kLast = {kSlack_m, 6, 0.25, 0.03};        // m; choice: the finest
inline constexpr double kAnotherThing = 1e4;    // nats; limit: a size out of its range, by its log
inline constexpr double kAnother_m = 1.0;       // m; choice: nearer places are one
inline constexpr double kSpreadFirst_m = 0.05;  // m; choice: no wall is surer
inline constexpr double kSpreadDrop = 0.5;      // nats; derived: one σ of a Gaussian
inline constexpr double kSystematic_m = 0.2;    // m; choice: of poses and crooked walls, all rays
inline constexpr int kOffspring = 12;  // 1; choice: Hansen's default of six parameters is 9
inline constexpr int kParents = kOffspring / 2;    // 1; derived: Hansen's half
inline constexpr double kLeastEigenvalue = 1e-12;  // 1; limit: rounding makes none negative

// Which places go together.
inline constexpr double kTells = 3.0;           // nats; measured: FIELD.md's part 2, 4, 20 to 1
inline constexpr double kOwnedWithin_m = 0.5;   // m; choice: a building stands for returns so near
inline constexpr double kOverlap = 400.0;       // nats; choice: for all of a building on another
inline constexpr double kLeastWorth = 1e-9;     // nats; limit: a gain, not rounding
inline constexpr int kNoMode = -1;              // index; choice: of a building that has no place
inline constexpr double kLeastEvidence = 10.0;  // nats; measured: FIELD.md's part 2, 4

// Terraces.
inline constexpr double kHouseFills = 0.8;           // 1; choice: of its bounding rectangle
inline constexpr double kFaceOff_m = 1.5;            // m; choice: of a face from that of another
inline constexpr double kWallToWall_m = 1.0;         // m; choice: between places, along it
inline constexpr double kRowTurn = toRadians(10.0);  // rad; choice: more is no row
inline constexpr double kRowCell_m = 0.25;           // m; choice: where houses may end, a wall
inline constexpr std::size_t kUndrawn = static_cast<std::size_t>(-1);  // index; choice: none
inline constexpr double kThingLogWidth = 0.5;  // 1; choice: σ about the mean of the drawn
/// Of how far a house is drawn off, what all of a row share.
inline constexpr double kSharedShift = 0.5;  // 1; measured: root of 0.26, core/sketch_study
inline constexpr double kMostShift = 3.0;    // σ; choice: all of them off together
inline constexpr double kShiftStep = 0.5;    // σ; choice: half of what one tells
inline constexpr double kFaceDepth_m = 0.1;  // m; paper: the cell of its map
inline constexpr double kBeforeFace = 0.25;  // 1; choice: of a return, from a shed
inline constexpr double kFaceStep_m = 1.0;   // m; choice: σ of a face against the row's
inline constexpr double kFaceTemper = 0.5;   // 1; choice: neighbouring cells have one error
inline constexpr double kWallShare = 0.25;   // 1; choice: of a row's returns, else a gap
inline constexpr double kFaceReturns = 2.0;  // returns; choice: of a cell that was seen

// What is drawn right, and how the map lies.
inline constexpr int kMostRounds = 50;        // rounds; limit: it has settled before
inline constexpr double kSettled = 1e-6;      // nats; limit: of a round
inline constexpr double kMisfitted = 0.15;    // 1; measured: fits of true maps to other things
inline constexpr double kMisfit_m = 1.5;      // m; measured: σ of such a side
inline constexpr double kTogether = 8.0;      // nats; measured: true maps 10 on, chance up to 6
inline constexpr double kStatedSides = 4.0;   // sides; choice: what the drawing says counts as
inline constexpr double kDrawnSlack_m = 0.3;  // m; choice: of walls that were not fitted
inline constexpr double kFoundRear_m = 2.7;   // m; measured: rear walls found, FIELD.md's part 2, 1
inline constexpr double kLabelled_m = 1.0;    // m; measured: σ of what was found, METHOD.md
inline constexpr double kStartTurn = toRadians(1.0);  // rad; choice: σ of a drawn start
inline constexpr double kStart_m = 0.3;               // m; choice: the same
inline constexpr int kLeastToRefute = 5;  // buildings; choice: fewer may all be misplaced
/// Where what is drawn off goes together by 1/e: neighbours 0.76 extents apart do by 0.26.
inline constexpr double kTogetherReach = 0.56;              // extents; measured: core/sketch_study
inline constexpr double kLeastStartTurn = toRadians(0.01);  // rad; limit: of one said to be exact

}  // namespace handmap::outlines
