// Noise that is a function of the place: both cameras and every frame see the same. Band-limited:
// what is smaller than a pixel fades to its mean.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace handmap {

inline std::uint32_t hashOf(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  std::uint32_t h = a * 0x9E3779B1U ^ b * 0x85EBCA77U ^ c * 0xC2B2AE3DU;
  h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12)) * 0x297A2D39U;
  return h ^ (h >> 15);
}

/// 0 … 1 for whole numbers.
inline float randomAt(int a, int b, std::uint32_t seed) {
  return static_cast<float>(
             hashOf(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), seed) >> 8) *
         0x1p-24F;
}

inline int floorOf(float x) {
  const int whole = static_cast<int>(x);
  return whole - (static_cast<float>(whole) > x ? 1 : 0);
}

/// -1 … 1, smooth between whole numbers.
inline float smoothNoise(float x, float y, std::uint32_t seed) {
  const int i = floorOf(x);
  const int j = floorOf(y);
  const float a = x - static_cast<float>(i);
  const float b = y - static_cast<float>(j);
  const float s = a * a * (3.0F - 2.0F * a);
  const float t = b * b * (3.0F - 2.0F * b);
  const float low = randomAt(i, j, seed) * (1.0F - s) + randomAt(i + 1, j, seed) * s;
  const float high = randomAt(i, j + 1, seed) * (1.0F - s) + randomAt(i + 1, j + 1, seed) * s;
  return 2.0F * (low * (1.0F - t) + high * t) - 1.0F;
}

/// How much of a pattern of this size is left when a pixel covers `pixel` of it.
inline float visible(float size, float pixel) {
  return std::clamp(1.6F - 1.6F * pixel / size, 0.0F, 1.0F);
}

/// Noise of one size at a place given in metres; nothing where a pixel covers it.
inline float grain(float u, float v, float size, float pixel, std::uint32_t seed) {
  const float share = visible(size, pixel);
  return share > 0.0F ? share * smoothNoise(u / size, v / size, seed) : 0.0F;
}

/// The share of a pixel at `x`, `pixel` wide, that lies within low … high.
inline float coverage(float x, float low, float high, float pixel) {
  const float width = std::max(pixel, 1e-4F);
  const float inside = std::min(x + width / 2.0F, high) - std::max(x - width / 2.0F, low);
  return std::clamp(inside / width, 0.0F, 1.0F);
}

/// The same for stripes that cover the first `share` of every period.
inline float stripes(float x, float period, float share, float pixel) {
  const float phase = x - period * static_cast<float>(floorOf(x / period));
  const float sharp = coverage(phase, 0.0F, share * period, pixel) +
                      coverage(phase, period, (1.0F + share) * period, pixel);
  const float left = visible(period, pixel);
  return left * std::min(1.0F, sharp) + (1.0F - left) * share;
}

}  // namespace handmap
