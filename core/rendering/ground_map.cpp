#include "core/rendering/ground_map.h"

#include <algorithm>

#include "core/rendering/noise.h"

namespace handmap {

namespace {

constexpr double kRoadCell_m = 0.5;
constexpr double kReach_m = 90.0;
constexpr double kRoadReach_m = 40.0;  // a leg farther out is no part of it
constexpr double kLeastLeg_m = 1.0;
constexpr double kBeyond_m = 100.0;  // the road goes on past both ends of the route
constexpr float kKerb_m = 4.0F;
constexpr float kKerbWidth_m = 0.16F;
constexpr float kPavement_m = 5.4F;
constexpr float kFar_m = 1e3F;

std::vector<Vec2> prolonged(std::vector<Vec2> route) {
  const auto past = [](const Vec2& last, const Vec2& other) -> Vec2 {
    const double length = (last - other).norm();
    return length > 0.0 ? Vec2(last + kBeyond_m / length * (last - other)) : last;
  };
  // A drawn line may have very many points.
  const auto close = [](const Vec2& a, const Vec2& b) { return (a - b).norm() < kLeastLeg_m; };
  route.erase(std::unique(route.begin(), route.end(), close), route.end());
  if (route.size() < 2) return route;
  const std::size_t n = route.size();
  route.front() = past(route[0], route[1]);
  route.back() = past(route[n - 1], route[n - 2]);
  return route;
}

/// Metres from the polyline for every cell; interpolation is then exact but at bends.
cv::Mat1f distanceMap(const std::vector<Vec2>& line, const Vec2& low, int side) {
  cv::Mat1f distance(side, side, kFar_m);
  const Vec2 centre = low + Vec2::Constant(kReach_m);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Segment leg{line[i - 1], line[i]};
    if (distanceTo(leg, centre) > kReach_m + kRoadReach_m) continue;
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        const Vec2 place = low + kRoadCell_m * Vec2(column + 0.5, row + 0.5);
        float& nearest = distance(row, column);
        nearest = std::min(nearest, static_cast<float>(distanceTo(leg, place)));
      }
    }
  }
  return distance;
}

}  // namespace

GroundMap::GroundMap(const std::vector<Vec2>& route, const Vec2& centre, std::uint64_t seed)
    : seed_(static_cast<std::uint32_t>(seed)) {
  // Cells stay where they are in the world however the robot moves.
  low_ = ((centre - Vec2::Constant(kReach_m)) / kRoadCell_m).array().floor() * kRoadCell_m;
  road_ = distanceMap(prolonged(route), low_, static_cast<int>(2.0 * kReach_m / kRoadCell_m));
}

float GroundMap::sampled(const cv::Mat1f& map, float x, float y, float outside) const {
  const float cell = static_cast<float>(2.0 * kReach_m) / static_cast<float>(map.cols);
  const float u = (x - static_cast<float>(low_.x())) / cell - 0.5F;
  const float v = (y - static_cast<float>(low_.y())) / cell - 0.5F;
  const auto last = static_cast<float>(map.cols - 2);
  if (!(u >= 0.0F && v >= 0.0F && u < last && v < last)) return outside;
  const int i = static_cast<int>(u);
  const int j = static_cast<int>(v);
  const float a = u - static_cast<float>(i);
  const float b = v - static_cast<float>(j);
  const float* low = map[j] + i;
  const float* high = map[j + 1] + i;
  return (1.0F - b) * ((1.0F - a) * low[0] + a * low[1]) + b * ((1.0F - a) * high[0] + a * high[1]);
}

Label GroundMap::labelAt(float x, float y) const {
  const float distance = sampled(road_, x, y, kFar_m);
  if (distance < kKerb_m) return Label::Road;
  return distance < kPavement_m ? Label::Pavement : Label::Tree;
}

Colour GroundMap::roadAt(float x, float y, float pixel) const {
  const float patch = smoothNoise(x / 7.0F, y / 7.0F, seed_ + 1) > 0.55F ? -0.25F : 0.0F;
  const float bright = 1.0F + patch + 0.25F * grain(x, y, 0.05F, pixel, seed_ + 2) +
                       0.16F * grain(x, y, 0.3F, pixel, seed_ + 3) +
                       0.16F * grain(x, y, 1.7F, pixel, seed_ + 4);
  return Colour(0.125F, 0.125F, 0.128F) * bright;
}

Colour GroundMap::gardenAt(float x, float y, float pixel) const {
  const float paved = smoothNoise(x / 5.0F, y / 5.0F, seed_ + 6);
  const float fine = 0.35F * grain(x, y, 0.06F, pixel, seed_ + 7) +
                     0.25F * grain(x, y, 0.25F, pixel, seed_ + 8) +
                     0.25F * grain(x, y, 1.3F, pixel, seed_ + 9);
  if (paved > 0.5F) return Colour(0.26F, 0.23F, 0.19F) * (1.0F + 0.6F * fine);
  const float dry = 0.5F + 0.5F * smoothNoise(x / 6.0F, y / 6.0F, seed_ + 10);
  return Colour(0.075F + 0.05F * dry, 0.115F + 0.02F * dry, 0.035F) * (1.0F + fine);
}

Colour GroundMap::colourAt(float x, float y, float pixel) const {
  const float distance = sampled(road_, x, y, kFar_m);
  const float road = coverage(distance, -1.0F, kKerb_m, pixel);
  const float kerb = coverage(distance, kKerb_m, kKerb_m + kKerbWidth_m, pixel);
  const float pavement = coverage(distance, kKerb_m + kKerbWidth_m, kPavement_m, pixel);
  Colour colour = Colour::Zero();
  if (road > 0.0F) {
    const float gutter = coverage(distance, kKerb_m - 0.3F, kKerb_m, pixel);
    colour += road * (1.0F - 0.25F * gutter) * roadAt(x, y, pixel);
  }
  if (kerb + pavement > 0.0F) {
    const float joints = std::max(stripes(x, 0.5F, 0.03F, pixel), stripes(y, 0.5F, 0.03F, pixel));
    const float slab = randomAt(floorOf(x / 0.5F), floorOf(y / 0.5F), seed_ + 11) - 0.5F;
    const float bright = 1.0F - 0.35F * joints + 0.22F * slab * visible(0.5F, pixel) +
                         0.15F * grain(x, y, 0.08F, pixel, seed_ + 12) +
                         0.18F * grain(x, y, 1.1F, pixel, seed_ + 13);
    colour += (pavement * bright + 1.25F * kerb) * Colour(0.24F, 0.235F, 0.22F);
  }
  const float rest = 1.0F - road - kerb - pavement;
  if (rest > 0.0F) colour += rest * gardenAt(x, y, pixel);
  return colour.max(0.01F);
}

}  // namespace handmap
