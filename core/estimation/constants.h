// The numbers of the room, each with its unit and where it comes from.
#pragma once

#include <array>
#include <cstddef>

namespace handmap::estimation {

// What is worked on.
inline constexpr int kParticles = 100;          // 1; paper: of its filter
inline constexpr double kActive_m = 50.0;       // m; choice: frames farther behind are not searched
inline constexpr std::size_t kMostActive = 40;  // keyframes; choice: that are searched, 80 m
inline constexpr std::size_t kMostKept = 1500;  // keyframes; choice: that the end may correct, 3 km
inline constexpr std::size_t kWindow = 12;     // keyframes; choice: that the next may correct, 24 m
inline constexpr double kNearLimits = 2.5;     // limits; choice: labels are looked at anew
inline constexpr std::size_t kFromStart = 10;  // keyframes; choice: 20 m, as sure as wheels, for
                                               // the way has to turn to the drawing somewhere
inline constexpr double kClose_m = 3.0;  // m; choice: nearer key frames take turns, it drives on
inline constexpr std::size_t kLastPoses = 200;      // keyframes; choice: tell a building's side
inline constexpr std::size_t kMostLabelled = 60;    // buildings; choice: so much time, at the end
inline constexpr std::size_t kMostSmoothed = 300;   // buildings; choice: so much time, far away
inline constexpr std::size_t kMostCorrected = 100;  // buildings; choice: so much time, far away

// Slack across walls, from wide to catch to narrow to settle.
inline constexpr std::array kWindowSlacks_m{0.3, 0.1};       // m; choice: of the last poses
inline constexpr std::array kLoopSlacks_m{0.5};              // m; choice: of a closed loop
inline constexpr std::array kPeriodicSlacks_m{0.1};          // m; choice: now and then
inline constexpr std::array kFinalSlacks_m{0.2, 0.1, 0.03};  // m; choice: at the end
inline constexpr int kMostIterations = 10;                   // iterations; limit: with one slack
inline constexpr double kSettled_m = 0.02;                   // m; limit: no pose moves any more
inline constexpr int kPeriodicIterations = 3;                // iterations; choice: now and then
inline constexpr std::size_t kLeastPeriod = 25;              // keyframes; choice: two windows
inline constexpr std::size_t kPeriodShare = 8;  // 1; choice: of the run, a frame costs the same

// Drift of a way that buildings in sight hold, one σ.
inline constexpr double kLeastShift_m = 1.0;     // m; choice: of found buildings
inline constexpr double kShiftPerMetre = 0.01;   // 1; choice: of matched scans
inline constexpr double kLeastTurn = 0.03;       // rad; choice: of found buildings
inline constexpr double kTurnPerMetre = 0.0001;  // rad/m; choice: 0.01 in 100 m

// What is shown.
inline constexpr double kSlightDoubt = 0.1;   // 1; choice: nobody asks about less
inline constexpr double kLeastDrawn_m = 0.1;  // m; choice: no drawing is surer of its buildings
inline constexpr double kLeastShown_m = 1.0;  // m; choice: what is drawn has an inside
inline constexpr float kSureCell = 5.0F;      // nats; choice: in a cell, as strong as is shown

}  // namespace handmap::estimation
