// What a map file may hold. Metres, square metres, degrees.
#pragma once

#include <cstddef>
#include <cstdint>

namespace handmap {

inline constexpr int kMapVersion = 1;
inline constexpr std::uintmax_t kMaxMapBytes = 64u << 20;
inline constexpr std::size_t kMaxTextBytes = 4096;
inline constexpr std::size_t kMaxBuildings = 100'000;
inline constexpr std::size_t kMaxLandmarks = 100'000;
inline constexpr std::size_t kMaxRoutePoints = 100'000;
inline constexpr std::size_t kMaxUnderlays = 100;  ///< each may become a large picture in memory
inline constexpr std::size_t kMaxPolygonVertices = 2'000;
/// Of all buildings: whether a polygon meets itself takes a time with the square of its vertices.
inline constexpr std::size_t kMaxVertices = 500'000;
inline constexpr double kMinPolygonArea = 1e-4;
inline constexpr double kMaxCoordinate = 1e6;
inline constexpr double kMaxSize = 1e5;
inline constexpr double kMaxSigma = 1e5;
inline constexpr double kMaxScaleSigma = 1.0;
inline constexpr double kMaxTurnSigmaDeg = 180.0;
inline constexpr double kMaxHeadingDeg = 3600.0;
inline constexpr double kMaxLatitudeDeg = 89.0;  ///< at the poles there is no east
inline constexpr double kMaxMetresPerPixel = 1e3;

}  // namespace handmap
