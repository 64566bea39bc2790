// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "core/geometry/pose2.h"

namespace handmap::perception {

// What is a wall: above the ground, by its extent upwards.
inline constexpr double kLeastHeight_m = 1.9;  // m; measured: METHOD.md, cars, low hedges end below
inline constexpr double kMostHeight_m = 12.0;  // m; choice: of four floors
inline constexpr double kLeastExtent_m =
    1.0;  // m; measured: METHOD.md, in one column, twice as much is sure
inline constexpr double kNearestWall_m = 1.0;   // m; choice: nearer is what the robot carries
inline constexpr double kSensorHeight_m = 1.5;  // m; choice: a metre more or less is no difference
inline constexpr float kTall_m = 1.8F;     // m; measured: FIELD.md's part 2, 2, above most cars
inline constexpr float kHighest_m = 9.0F;  // m; measured: FIELD.md's part 2, 2, roofs are higher

// Range sensors, and what they see.
inline constexpr double kFar_m =
    35.0;  // m; measured: FIELD.md (b), farther returns are sparse, and stereo is off by 2 m
inline constexpr double kWall_m =
    0.1;  // m; measured: FIELD.md (b), σ of a wall in two visits, plaster, frames, poses
inline constexpr double kLaserSigma_m = 0.03;     // m; choice: data sheets, until it is measured
inline constexpr double kNoiseOffset_m = 0.1;     // m; choice: until it is measured, METHOD.md 0.05
inline constexpr double kNoiseQuadratic = 0.002;  // 1/m; choice: the same, METHOD.md 0.0021
inline constexpr float kScanSigma_m = 0.05F;      // m; choice: that, and a wall within a direction
inline constexpr float kLevel_m = 0.3F;  // m; choice: what is not quite level is off, the ground is
inline constexpr std::size_t kDirections = 720;  // 1; choice: half a degree, as most scanners
inline constexpr double kDirection = 2.0 * kPi / kDirections;  // rad; derived: of all kinds
inline constexpr std::size_t kDegrees = kDirections / 2;  // 1; derived: wider than any scanner's
inline constexpr double kMostADirection = 2.5;  // returns; choice: in a degree, a wall has more
inline constexpr double kOneStep = 1.6;         // 1; choice: of the median step of a sweep
inline constexpr double kRegular = 0.8;    // 1; measured: of steps, scanners 0.93, at random 0.67
inline constexpr double kAtFirst = 10.0;   // steps; choice: that are supposed to be a scanner's
inline constexpr float kColumn_m = 0.25F;  // m; choice: cells of vertical extent, a wall's
inline constexpr std::size_t kLeastPoints = 3;  // points; choice: of a cell, two may be strays
inline constexpr float kGroundCell_m = 2.0F;    // m; choice: has some of the ground at 30 m still
inline constexpr float kMaxSlope = 0.15F;       // 1; choice: the steepest streets are near it
inline constexpr float kUnknownHeight_m = std::numeric_limits<float>::infinity();  // m; limit: none

// What is looked over.
inline constexpr double kLowCell_m = 0.5;    // m; choice: less than a hedge is thick
inline constexpr float kPassStep_m = 0.4F;   // m; choice: along a ray, less than kLowCell_m
inline constexpr std::size_t kLowBins = 10;  // 1; choice: of height, and one for all above
inline constexpr int kPasses = 4;  // rays; choice: fewer are strays; and as many for each stop, for
                                   // windows let rays pass, but the frame around them does not

// Frames that were joined.
inline constexpr double kSame_m = 0.005;    // m; measured: joined points 0.001 (83 to 87 %), lasers
                                            // 0.6 % of theirs
inline constexpr double kMoved_m = 0.3;     // m; choice: a robot that stands may well see the same
inline constexpr std::size_t kSample = 16;  // points; choice: most of them were there
inline constexpr double kJoinedWay_m = 200.0;        // m; choice: along which they may be joined
inline constexpr std::size_t kMostPlaces = 200'000;  // places; limit: 10 MB

// The local map.
inline constexpr double kMapCell_m = 0.1;           // m; paper: of its local map
inline constexpr double kSmoothing_m = 0.2;         // m; choice: σ, as the noise of near points
inline constexpr double kSaturation = 3.0;          // votes; choice: so many are as sure as can be
inline constexpr double kPath_m = 30.0;             // m; choice: of way, odometry is right along it
inline constexpr double kMinTurn = toRadians(1.0);  // rad; choice: the same
inline constexpr std::size_t kMostScans = 400;      // scans; limit: of one that turns for ever
inline constexpr int kMaxSide = 8192;               // cells; limit: 256 MB
inline constexpr double kFraction = 65536.0;        // 1; choice: 16 bits of a cell, along a ray
inline constexpr int kMaxRaySteps = 50;             // cells; limit: to either side, 2σ of 2.5 m
inline constexpr std::size_t kBlock = 16;           // cells; choice: what is smoothed together

// Stereo matching.
inline constexpr int kBlockSize_px = 7;         // px; choice: OpenCV advises 3 to 11
inline constexpr int kPreFilterCap = 31;        // grey; choice: what OpenCV advises, of gradients
inline constexpr int kUniqueness_percent = 10;  // %; choice: what OpenCV advises, of the second
inline constexpr double kOff_px = 1.0;  // px; choice: OpenCV advises, of disparities of one surface
inline constexpr int kSpeckle_px = 100;      // px; choice: what OpenCV advises, an area
inline constexpr int kTextureWindow_px = 9;  // px; choice: about what is matched
inline constexpr float kMinTexture = 0.3F;   // grey; choice: mean step, less is sky or plaster
inline constexpr float kUnknownDisparity = -1.0F;  // px; limit: none
inline constexpr double kNearest_m = 4.0;          // m; choice: so near a wall should be seen
inline constexpr double kLeastFocal_px_m = 180.0;  // px·m; measured: matchers pull to whole pixels
inline constexpr double kDisparitySigma_px = 0.25;  // px; choice: σ, at the reduced size
inline constexpr double kMostSigma_m = 1.0;         // m; choice: noisier points tell nothing
inline constexpr std::size_t kSupport = 8;          // px; choice: of a column, that a surface needs
inline constexpr double kBinsPerPixel = 2.0;        // 1; choice: half a pixel, two σ
inline constexpr int kReach = 1;  // bins; choice: to either side that are one wall

// The ground before a stereo camera.
inline constexpr int kGroundStep_px = 3;           // px; choice: more pixels tell the same
inline constexpr double kGroundNearest_m = 2.0;    // m; choice: beyond the robot itself
inline constexpr double kGroundFarthest_m = 20.0;  // m; choice: so far streets are flat
inline constexpr double kGroundAside_m = 10.0;     // m; choice: the same
inline constexpr std::array kGroundWidths_m{0.6, 0.4, 0.3, 0.2,
                                            0.2};  // m; choice: half widths of Tukey's weight, from
                                                   // what the mount may be off to what a road is
inline constexpr double kGroundSigma_m = 0.05;     // m; choice: σ of the mount, of a pixel at 10 m
inline constexpr double kGroundSlope = 0.02;       // 1; choice: σ of the mount
inline constexpr double kPriorPixels =
    100.0;  // px; choice: that the mount counts as, they err together

}  // namespace handmap::perception
