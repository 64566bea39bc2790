// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <cstddef>

#include "core/geometry/pose2.h"
#include "core/trajectory/constants.h"

namespace handmap::map_match {

// What is laid on the walls.
inline constexpr double kKeyframe_m = 3.0;  // m; choice: a seventh of a window, which so overlap
inline constexpr double kBehind_m = 20.0;   // m; choice: of way, enough for walls of two directions
inline constexpr double kAside_m = kBehind_m / 2.0;  // m; derived: the same window, at the end
inline constexpr double kSpacing_m = 0.25;           // m; choice: of points, half the last gate
inline constexpr int kLeastMatched = 30;  // points; choice: 7 m of wall, less fits anywhere
inline constexpr double kOnWall_m =
    trajectory::kGates_m.back();          // m; derived: what the last gate lets in
inline constexpr int kLeastOnWalls = 10;  // points; choice: 2 m of a building, else it is not seen
inline constexpr double kNear_m = 60.0;   // m; limit: a point map holds 64 m around one place
inline constexpr double kStale_m = 10.0;  // m; choice: of way, what is within 50 m is then there

// What is known of it: the README's table of residuals.
inline constexpr double kFloorTurn = toRadians(0.6);       // rad; choice: 0.3 m over 30 m of wall
inline constexpr double kStart_m = 1.0;                    // m; choice: a start set by hand
inline constexpr double kStartTurn = toRadians(3.0);       // rad; choice: the same
inline constexpr double kLeastStart_m = 0.05;              // m; choice: a start said to be exact
inline constexpr double kLeastStartTurn = toRadians(0.2);  // rad; choice: the same

// How long is worked.
inline constexpr std::size_t kAlike = 8;  // keyframes; choice: in a row about as uncertain
inline constexpr int kMostRounds = 4;     // rounds; limit: at the end, of laying all anew
inline constexpr double kStill_m = 0.02;  // m; choice: no pose moves by more, a laser's noise

// A grid of another program, laid on the drawing.
inline constexpr double kWallStep_m = 0.5;  // m; choice: of points on the walls, ten cells
inline constexpr double kMargin_m = 15.0;   // m; choice: around the drawing, a street's width
inline constexpr double kMostPixels = 8e6;  // cells; limit: of memory, a kilometre at 0.35 m
inline constexpr double kInside_m = 2.0;    // m; choice: a building from there on, nobody was in it
inline constexpr double kFaces_m = 6.0;  // m; choice: a wall that was seen has free ground so near
inline constexpr double kSameNormal = 0.85;        // cosine; choice: 30°, drawings are turned
inline constexpr std::size_t kMostPieces = 6'000;  // points; limit: more tell the same
inline constexpr std::size_t kCandidates = 40;     // places; limit: of which the rest is refined
inline constexpr double kSameByFar_m = 5.0;        // m; choice: nearer ones are one place
inline constexpr double kSameSigmas =
    5.0;  // σ; choice: a poor drawing tells no places apart so near
inline constexpr double kLeastSupported = 0.5;  // share; choice: of the walls, most of them
inline constexpr double kNearlyAsWell = 0.84;   // share; measured: README, of the best one's score
inline constexpr double kMostSide = 300.0;      // cells; limit: of the coarsest search
inline constexpr std::size_t kOfOneTurn = 3;    // places; choice: of one turn, else one takes all
inline constexpr double kShared = 40.0;   // points; choice: neighbours on a wall are off together
inline constexpr double kSmall_m = 0.05;  // m; choice: cells are looked at as if they were so small

}  // namespace handmap::map_match
