// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <cstddef>

namespace handmap::loops {

// Whether two boxes are one building.
inline constexpr double kSeen_m = 1.0;       // m; choice: σ of a wall that is compared, at most
inline constexpr double kWallFloor_m = 0.2;  // m; choice: σ of what two boxes of a wall may differ
inline constexpr double kHeadingFloor = 0.02;  // rad; choice: the same of their headings
inline constexpr double kGate = 12.0;          // σ²; choice: of one parameter, 3.5 σ
inline constexpr double kSure = 10.0;  // nats; choice: as accepting an outline, FIELD.md 2 and 4

}  // namespace handmap::loops
