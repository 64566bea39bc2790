// The numbers of the room, each with its unit and where it comes from. README.md has the table of
// residuals.
#pragma once

#include <array>
#include <cstddef>

namespace handmap::smoothing {

// States.
inline constexpr int kPoseSize = 3;      // 1; derived: x, y, heading
inline constexpr int kBoxSize = 5;       // 1; derived: Box::reach, heading
inline constexpr int kLandmarkSize = 2;  // 1; derived: x, y
inline constexpr int kMotionSize = 4;    // 1; derived: DrawingMotion::mean
inline constexpr int kNone = -1;         // index; limit: not among the unknowns

// Kernels and gates.
inline constexpr double kRobust = 2.0;  // σ; choice: a sighting weighs half there, some are wrong
inline constexpr double kNearLimit = 2.0;     // σ; choice: 98 % of the returns come back
inline constexpr double kEndsAreWorse = 3.0;  // 1; choice: systematic, eaves, gutters and branches
inline constexpr double kTogether = 2.0;  // σ; choice: what stands together is drawn wrong together

// Priors, one σ.
inline constexpr double kScale = 0.003;     // 1; choice: of the odometry, wheels well calibrated
inline constexpr double kLeastBias = 1e-9;  // 1/m; limit: where the scan says that there is none
inline constexpr double kUnknownHeading = 0.2;  // rad; choice: the drawing has no direction
inline constexpr double kSameHeading = 0.01;    // rad; choice: the same
inline constexpr double kNowhere_m2 = 1e6;      // m²; limit: a wall that was not seen

// How far an iteration goes, one σ.
inline constexpr double kScaleChange = 0.002;  // 1; choice: what one window tells is a part
inline constexpr double kSizeDamping_m = 4.0;  // m; choice: of what no ray tells
inline constexpr double kPlaceDamping_m = 10.0 * kSizeDamping_m;  // m; derived: of no account
inline constexpr double kMostTurn = 0.05;    // rad; choice: as far as slopes hold
inline constexpr double kLeastSize_m = 2.0;  // m; choice: no building is smaller

// The heading's variance of the odometry.
inline constexpr std::size_t kStretch = 8;    // keyframes; choice: 16 m
inline constexpr std::size_t kUnsettled = 3;  // keyframes; choice: the newest still move
inline constexpr double kForgetting = 0.98;   // 1; choice: a key frame, 100 m
inline constexpr double kAssumed_m = 100.0;   // m; choice: that the assumption counts for

// Landmarks.
inline constexpr int kLeastLooks = 3;  // 1; choice: of rays, of frames, the third tells of the two
inline constexpr float kFarthest_m = 30.0F;   // m; choice: farther things are too few rays
inline constexpr float kWidest_m = 3.0F;      // m; choice: a tree, a kiosk
inline constexpr float kApart_m = 1.5F;       // m; choice: from what is behind, from each other
inline constexpr float kMostSpacing = 0.03F;  // rad; choice: three rays of a laser of 0.5°
inline constexpr float kDepth_m = 0.6F;       // m; choice: between neighbours of one thing
inline constexpr float kDepthSigmas = 3.0F;   // σ; choice: the same, of the range noise
inline constexpr int kBeside = 2;             // rays; choice: that one stray does not decide
inline constexpr float kMiddle = 0.39F;   // 1; derived: of its width, half a circle's mean depth
inline constexpr double kBearing = 0.4;   // rays; choice: σ of the middle
inline constexpr double kShape_m = 0.05;  // m; choice: σ, things are not quite round
inline constexpr double kRangeShape_m = 0.15;  // m; choice: σ, the same along the ray
inline constexpr double kNearest_m = 0.5;      // m; choice: no robot comes nearer to a thing

}  // namespace handmap::smoothing
