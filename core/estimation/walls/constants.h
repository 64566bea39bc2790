// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>
#include <cstddef>

#include "core/perception/constants.h"

namespace handmap::walls {

// The sensor model.
inline constexpr double kHit = 0.9;      // 1; measured: FIELD.md (c), else it is looked through
inline constexpr double kSilence = 0.1;  // 1; choice: FIELD.md, table C, 0.02 to 20 m, 0.2 at 45
inline constexpr double kRecognised = 0.85;  // 1; measured: METHOD.md, look like walls
inline constexpr double kWallLike = 0.01;    // 1/m; choice: density of other things that do
inline constexpr double kOthers = 0.2;       // 1/m; choice: density of things that do not
inline constexpr double kTemper = 0.4;      // 1; measured: METHOD.md, a frame's rays share its pose
inline constexpr float kSilentUpTo = 0.9F;  // 1; choice: of the limit, noise takes some beyond it
inline constexpr int kSilent = -1;          // label; limit: nothing came back
inline constexpr int kLabels = 5;           // labels; choice: 0 no wall … 4 wall
inline constexpr int kLooksLikeAWall = 3;   // label; choice: likelier a wall than not

// Its table.
inline constexpr float kReach = 4.0F;          // σ; choice: beyond, a return is of another thing
inline constexpr float kStepsPerSigma = 8.0F;  // 1; choice: of the table
inline constexpr std::size_t kSteps =
    static_cast<std::size_t>(2.0F * kReach * kStepsPerSigma);  // 1; derived: both sides
inline constexpr std::size_t kLevels = 56;                     // 1; choice: of variance, to 16 m²
inline constexpr int kLeastLevel = 117 * 4;     // 1; derived: a variance of 2⁻¹⁰ m², as bits
inline constexpr float kDistanceStep_m = 0.5F;  // m; choice: the noise changes by 4 %

// Evidence.
inline constexpr double kCell_m = 0.5;    // m; choice: METHOD.md's 0.25 costs twice as much
inline constexpr double kScale = 256.0;   // 1/nat; choice: 0.4 % of a nat, 8 million nats
inline constexpr double kGrazing = 0.05;  // sine; choice: 3°, below it a ray tells nothing
inline constexpr double kMoved_m = 0.08;  // m; choice: a sixth of a cell
inline constexpr double kTurned = 0.005;  // rad; choice: 10 cm at 20 m
inline constexpr int kMostAnew = 4;       // frames; choice: so much time

// Walls in it.
inline constexpr double kLeastScore = 25.0;      // nats; choice: a wall alone, 40 with its sides
inline constexpr double kLeastWall_m = 3.0;      // m; choice: a garage
inline constexpr double kDrop = 15.0;            // nats; measured: METHOD.md 3, behind its end
inline constexpr double kTilt = toRadians(1.5);  // rad; choice: between tilted rows
inline constexpr std::array kTilts{0.0,          kTilt,       -kTilt,      2.0 * kTilt,
                                   -2.0 * kTilt, 3.0 * kTilt, -3.0 * kTilt};  // rad; derived: ±4.5°
inline constexpr double kSameWall_m = 3.0 * kCell_m;  // m; derived: between walls that are one
inline constexpr double kSameHeading = 0.7;           // cosine; choice: 45°
inline constexpr double kCommon = 0.3;    // 1; choice: of the shorter of walls that are one
inline constexpr std::size_t kLanes = 4;  // 1; limit: what any processor does at once

// Their directions.
inline constexpr double kDirectionsApart = 6.0 * kTilt;  // rad; derived: tilted rows reach the half
inline constexpr std::size_t kMostDirections = 9;  // 1; derived: so many differ by that, less one
inline constexpr int kPatience = 15;               // keyframes; choice: 30 m
inline constexpr std::size_t kBins = 60;           // 1; derived: as wide as kTilt
inline constexpr double kBin = kPi / 2.0 / static_cast<double>(kBins);  // rad; derived: kTilt
inline constexpr double kForgetting = 0.95;    // 1; choice: a key frame, 40 m
inline constexpr float kGap = 0.07F;           // rad; choice: between the returns of one piece
inline constexpr double kMostPiece_m = 12.0;   // m; choice: a front
inline constexpr double kLeastVotes_m = 20.0;  // m; choice: of a peak, two fronts
inline constexpr double kLeastShare = 0.12;    // 1; choice: of all votes, eight directions each

}  // namespace handmap::walls
