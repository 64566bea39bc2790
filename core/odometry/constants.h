// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <cstddef>

#include "core/odometry/odometry_noise.h"

namespace handmap {

// How measured motions err, one σ.
inline constexpr OdometryNoise kWheels{
    .along_per_m = 0.03,             // 1; measured: FIELD.md (a), on roads
    .aside_per_m = 0.01,             // 1; measured: FIELD.md (a)
    .least_m = 0.01,                 // m; measured: FIELD.md (a)
    .heading_variance_per_m = 2e-5,  // rad²/m; measured: FIELD.md (a)
    .heading_per_rad = 0.02,         // 1; measured: FIELD.md (a)
    .least_heading = 0.001};         // rad; measured: FIELD.md (a)
inline constexpr OdometryNoise kMatchedScans{
    .along_per_m = 0.012,              // 1; measured: FIELD.md (b), the laser of a campus
    .aside_per_m = 0.006,              // 1; measured: FIELD.md (b)
    .least_m = 0.02,                   // m; measured: FIELD.md (b)
    .heading_variance_per_m = 4.9e-7,  // rad²/m; measured: FIELD.md (b)
    .heading_per_rad = 0.006,          // 1; measured: FIELD.md (b)
    .least_heading = 0.0015};          // rad; measured: FIELD.md (b)

}  // namespace handmap

namespace handmap::odometry {

// What nothing tells.
inline constexpr double kUnheard_m_s = 1.0;    // m/s; choice: of one axis, a robot among people
inline constexpr double kUnheard_rad_s = 0.5;  // rad/s; choice: as they turn at corners
inline constexpr double kAnySpeed_s = 20.0;    // s; measured: 0.05 m/s², stretches of 3 to 13 s
                                               // were 0.02 to 2.6 m off
inline constexpr double kKeyframe_m = 2.0;     // m; choice: between key frames, a guess so far off
inline constexpr double kKeyframeTurn = 0.15;  // rad; measured: FIELD.md (a), between key frames
inline constexpr double kBelieved_s = 3.0;     // s; choice: that images may tell nothing
inline constexpr double kMetresARadian = 1.0;  // m/rad; choice: of the way, a turn on the spot

// Corners of a stereo pair.
inline constexpr int kWindow_px = 15;    // px; choice: of the tracker
inline constexpr int kLevels = 4;        // 1; choice: above the full image, 120 px
inline constexpr int kContrast = 8;      // grey; choice: low, for shade, the grid takes the best
inline constexpr int kGridColumns = 20;  // 1; choice: near corners tell the way, far ones the turn
inline constexpr int kGridRows = 8;      // 1; choice: the same
inline constexpr std::size_t kCornersPerCell = 4;  // corners; choice: 640 in all
inline constexpr float kMinDistance_px = 8.0F;     // px; choice: half a window
inline constexpr double kMinEigenvalue = 1e-3;     // 1; choice: OpenCV scales it to the window
inline constexpr int kTrackerSteps = 20;           // iterations; limit: of the tracker
inline constexpr double kTracked_px = 0.01;        // px; limit: OpenCV's default
inline constexpr float kPixel_px = 1.0F;  // px; choice: as rows agree, less is no disparity
inline constexpr float kMaxReturnError_px = 0.5F;  // px; choice: tracked there and back
inline constexpr int kFeatures = 1500;  // features; choice: of ORB, where tracking is lost

// The motion that they tell.
inline constexpr int kHypotheses = 150;  // 1; derived: of three matches of which half may be wrong
inline constexpr int kSampleIterations = 6;       // iterations; choice: on a sample near is enough
inline constexpr double kSampleConverged = 1e-4;  // m; limit: also rad, on a sample
inline constexpr int kRefinements = 3;            // rounds; choice: of the set of inliers
inline constexpr int kIterations = 8;             // iterations; limit: of each
inline constexpr double kConverged = 1e-7;        // m; limit: also rad
inline constexpr double kDiverged = 1e3;          // m; limit: also rad
inline constexpr double kPixelSigma = 0.35;       // px; choice: σ of a tracked corner
inline constexpr double kInlier_px = 2.0;         // px; choice: some 6 σ
inline constexpr double kNearestSeen_m = 0.1;     // m; limit: before the camera
inline constexpr double kNearestKept_m = 0.5;     // m; choice: before the camera, is still tracked
inline constexpr std::size_t kMinInliers = 15;    // matches; choice: 45 numbers for six
inline constexpr double kMinShare = 0.3;          // 1; choice: of tracked corners, move as one
inline constexpr double kMinAlike = 0.15;  // 1; choice: of features, most that look alike are not
inline constexpr std::size_t kMinCorners = 2 * kMinInliers;  // corners; derived: of a key pair
inline constexpr double kKeepKey = 0.5;  // 1; choice: of its corners, that must still be seen

}  // namespace handmap::odometry
