// The numbers of the room, each with its unit and where it comes from.
#pragma once

namespace handmap::explain {

// When a ray ended on a wall.
inline constexpr double kLeastCosine = 0.1;  // 1; choice: flatter rays tell nothing across the wall
inline constexpr double kLeastWall = 0.05;   // 1; choice: how surely a return is of a wall
inline constexpr double kOnWall_m = 0.5;     // m; choice: returns farther from a wall are not of it

// Which walls were seen.
inline constexpr int kLeastRays = 2;         // rays; derived: one makes no piece of a wall
inline constexpr int kLeastOfARun = 3;       // rays; choice: fewer may be strays
inline constexpr double kMissed_m = 1.0;     // m; choice: beside the noise, it is not of the wall
inline constexpr double kNoiseSigmas = 2.0;  // σ; choice: the noise of all but one ray in twenty
inline constexpr double kNear_m =
    5.0;  // m; choice: what stands so before a wall may be taken for it
inline constexpr int kMostBefore =
    4;  // 1; choice: of those on it, hedges and cars have many before

// What pulled at a wall.
inline constexpr double kShared_m = 0.2;       // m; choice: looks of one place are off together
inline constexpr double kOneLook_m = 1.0;      // m; choice: of way, looks nearer are one
inline constexpr double kLeastSigma_m = 0.01;  // m; limit: a guard against division by 0

// Where images saw it.
inline constexpr float kBuilding = 0.5F;   // 1; choice: probability, more likely than not
inline constexpr double kNearest_m = 0.5;  // m; choice: nearer than that nothing is in the image
inline constexpr double kUp_m = 3.0;  // m; choice: a storey, of a wall that nothing was judged of

}  // namespace handmap::explain
