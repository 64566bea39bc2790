// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <cstddef>

#include "core/geometry/pose2.h"

namespace handmap::labels {

// Hypotheses over all buildings.
inline constexpr double kFreeScale = 0.25;      // 1; choice: σ, for the 0.7 to 1.4 of METHOD.md
inline constexpr double kFan = toRadians(8.0);  // rad; choice: between hypotheses of a free turn, σ
inline constexpr int kFanSteps = 5;             // hypotheses; derived: to either side, ±40°
inline constexpr double kHopeless =
    25.0;  // nats; choice: behind the best, more than a building tells
inline constexpr double kSamePlace_m = 2.0;  // m; measured: README, of the farthest drawn building
inline constexpr int kMostAlike = 3;         // hypotheses; measured: README, with it there
inline constexpr double kUndrawnMargin_m = 20.0;  // m; choice: round the drawing things may stand
inline constexpr double kLeastSigma = 1e-4;       // 1; choice: also rad, 5 cm in 500 m
inline constexpr int kNone = -1;                  // index; limit: of nothing found
inline constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);  // index; limit: not drawn

// One drawn and one found building.
inline constexpr double kGate = 25.0;       // σ²; choice: of what is tried
inline constexpr double kMostTurned = 4.0;  // σ²/2; choice: that a heading costs at most
inline constexpr double kCarLong_m = 6.0;   // m; choice: longer is no car
inline constexpr double kCarWide_m = 3.0;   // m; choice: wider is no car
inline constexpr double kCarWell_m = 0.5;   // m; choice: σ of a wall seen well enough to say so

// Near the robot.
inline constexpr double kMostDoubt = 0.5;   // 1; choice: of a label that says something
inline constexpr double kNearSigmas = 3.0;  // σ; choice: so far off buildings are still near
inline constexpr double kReach_m = 100.0;   // m; choice: twice the sight
inline constexpr double kSure = 0.9;        // 1; choice: a loop closure has its own test
inline constexpr double kAssumed = 2.0;     // buildings; choice: the assumed scatter counts for
inline constexpr int kLeastSeen = 3;        // frames; choice: key frames that saw it

}  // namespace handmap::labels
