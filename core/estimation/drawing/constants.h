// The numbers of the room, each with its unit and where it comes from.
#pragma once

namespace handmap::drawing {

// What a found one tells of it.
inline constexpr double kSeen_m = 2.0;     // m; choice: σ of a wall that was seen, at most
inline constexpr double kUnlikely = 3.5;   // σ; choice: such a wall is of something built on
inline constexpr double kLeastKept = 0.3;  // 1; choice: of a drawn size whose side nobody saw

// How the drawing lies.
inline constexpr double kBlock_m = 50.0;  // m; choice: so far what is beside tells of a building
inline constexpr double kLeastVariance = 1e-9;  // m²; limit: a drawing may say that it is exact

}  // namespace handmap::drawing
