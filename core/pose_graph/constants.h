// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>

namespace handmap::pose_graph {

inline constexpr int kMostSteps = 12;           // iterations; limit: it has settled before
inline constexpr double kLeastGain = 1e-4;      // 1; limit: of the cost, less is not worth a step
inline constexpr double kFirstDamping = 1e-6;   // 1; limit: of the diagonal
inline constexpr double kDampingFactor = 10.0;  // 1; choice: Marquardt's
inline constexpr double kNotHeld = 1e9;         // m²; limit: variance of what nothing tells
inline constexpr std::array kDampings{0.0, 1e-9, 1e-6, 1e-3, 1.0};  // 1; choice: of the diagonal,
                                                                    // from rounding to half a step

}  // namespace handmap::pose_graph
