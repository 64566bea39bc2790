#include "core/rendering/sky.h"

#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr float kPiF = 3.14159265F;
constexpr float kBrightness = 1.4F;  // against walls: clouds saturate when streets are well exposed
constexpr float kHighestTrees = 0.095F;  // as a slope

struct Direction {
  float azimuth;  ///< only where trees may stand
  float slope;    ///< up over forward
};

Direction directionOf(const Vec3& ray) {
  const double flat = std::hypot(ray.x(), ray.y());
  const auto slope = static_cast<float>(ray.z() / std::max(flat, 1e-9));
  if (slope > kHighestTrees) return {0.0F, slope};
  return {static_cast<float>(std::atan2(ray.y(), ray.x())), slope};
}

/// Noise around the horizon that closes on itself.
float around(float azimuth, float count, std::uint32_t seed) {
  const float x = (azimuth + kPiF) / (2.0F * kPiF) * count;
  const int i = floorOf(x);
  const float a = x - static_cast<float>(i);
  const int n = static_cast<int>(count);
  const auto value = [&](int k) { return randomAt((k % n + n) % n, 0, seed); };
  return value(i) * (1.0F - a) + value(i + 1) * a;
}

}  // namespace

Sky::Sky(const Vec3& to_sun, float sun, std::uint64_t seed)
    : to_sun_(to_sun.cast<float>()), sun_(sun), seed_(static_cast<std::uint32_t>(seed)) {}

float Sky::treeLine(float azimuth) const {
  return 0.012F + 0.05F * around(azimuth, 24.0F, seed_ + 30) +
         0.02F * around(azimuth, 160.0F, seed_ + 31) + 0.008F * around(azimuth, 900.0F, seed_ + 32);
}

Label Sky::labelAt(const Vec3& ray) const {
  const Direction d = directionOf(ray);
  return d.slope < treeLine(d.azimuth) ? Label::Tree : Label::Sky;
}

Colour Sky::colourAt(const Vec3& ray, float pixel) const {
  const Direction d = directionOf(ray);
  const Eigen::Vector3f r = ray.cast<float>().normalized();
  const float height = std::max(0.0F, r.z());
  const float blue = std::min(1.0F, 1.6F * height);
  const Colour clear =
      (1.0F - blue) * Colour(0.80F, 0.88F, 0.98F) + blue * Colour(0.30F, 0.47F, 0.82F);
  const float x = r.x() / (height + 0.15F);
  const float y = r.y() / (height + 0.15F);
  const float puffs = 0.55F * smoothNoise(1.1F * x, 1.1F * y, seed_ + 33) +
                      0.28F * smoothNoise(2.7F * x, 2.7F * y, seed_ + 34) +
                      0.17F * smoothNoise(6.1F * x, 6.1F * y, seed_ + 35);
  const float overcast = 1.0F - std::min(sun_, 1.0F);
  const float cloud = std::clamp(2.2F * (puffs + 0.15F + 1.2F * overcast), 0.0F, 1.0F);
  const Colour grey = Colour(0.86F, 0.88F, 0.90F) * (1.0F + 0.22F * puffs);
  Colour sky = (1.0F - cloud) * clear + cloud * grey;
  const float glare = std::max(0.0F, r.dot(to_sun_));
  const float squared = glare * glare;
  const float eighth = squared * squared * squared * squared;
  sky += Colour(0.9F, 0.85F, 0.7F) * (sun_ * eighth * eighth * eighth);
  sky *= kBrightness;
  if (d.slope > kHighestTrees) return sky;
  const float trees = coverage(d.slope, -1.0F, treeLine(d.azimuth), pixel);
  const float rough = 1.0F + 0.35F * smoothNoise(d.azimuth * 140.0F, d.slope * 140.0F, seed_ + 36);
  return (1.0F - trees) * sky + trees * rough * Colour(0.10F, 0.14F, 0.11F);
}

}  // namespace handmap
