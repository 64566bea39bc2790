#include "core/estimation/buildings/noise_estimate.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/estimation/buildings/box_view.h"
#include "core/estimation/buildings/constants.h"

namespace handmap {

using namespace buildings;

void NoiseEstimate::add(const Frame& frame, std::span<const FoundBox> boxes,
                        const SensorModel& sensor) {
  for (Bin& bin : bins_) {
    bin.weight *= kForgetting;
    bin.squares *= kForgetting;
  }
  together_.weight *= kForgetting;
  together_.squares *= kForgetting;
  for (const FoundBox& found : boxes) {
    const BoxView view(found.box, frame.pose);
    if (view.inside() || !view.inReach(sensor.rangeLimit())) continue;
    std::array<double, 4> weights{};
    std::array<double, 4> errors{};
    view.forRays(frame.rays, [&](const FrameRay& ray) {
      if (ray.sight.label == walls::kSilent) return;
      const Entry entry = view.entry(ray);
      if (entry.distance < 0.0F || entry.cosine < kSteep) return;
      const auto index = static_cast<std::size_t>(entry.distance / kBin_m);
      const RangeNoise& noise = sensor.measured().noise;
      const auto distance = static_cast<double>(entry.distance);
      const double error = static_cast<double>(ray.sight.range) - distance - noise.bias(distance);
      const double sigma = noise.at(distance);
      if (index >= bins_.size() || std::abs(error) > walls::kReach * sigma) return;
      const double weight = sensor.responsibility(ray.sight.label, error, sigma);
      bins_[index].weight += weight;
      bins_[index].squares += weight * error * error;
      const double across = weight / (sigma * sigma);
      weights[static_cast<std::size_t>(entry.wall)] += across;
      errors[static_cast<std::size_t>(entry.wall)] += across * error * entry.cosine;
    });
    for (std::size_t k = 0; k < 4; ++k) {
      if (weights[k] < kLeastInformation) continue;
      const double mean = errors[k] / weights[k];
      together_.weight += 1.0;
      together_.squares += mean * mean - 1.0 / weights[k];
    }
  }
}

double NoiseEstimate::systematic() const {
  if (together_.weight < kLeastTogether) return perception::kLaserSigma_m;
  const double variance = together_.squares / together_.weight;
  return std::clamp(std::sqrt(std::max(variance, 0.0)), kLeastSystematic_m, kMostSystematic_m);
}

RangeNoise NoiseEstimate::fitted(const RangeNoise& assumed) const {
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  int bins = 0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    if (bins_[i].weight < kLeastReturns) continue;
    const double distance = (static_cast<double>(i) + 0.5) * kBin_m;
    const double sigma = std::sqrt(bins_[i].squares / bins_[i].weight);
    const Eigen::Vector2d slope(1.0, distance * distance);
    // The relative error of a σ depends on the number of returns alone.
    const double weight =
        bins_[i].weight / (sigma * sigma + perception::kLaserSigma_m * perception::kLaserSigma_m);
    matrix += weight * slope * slope.transpose();
    right += weight * sigma * slope;
    ++bins;
  }
  if (bins < 2) return assumed;
  const Eigen::Vector2d fit = matrix.ldlt().solve(right);
  RangeNoise noise{fit[0], fit[1], assumed.bias_per_m};
  if (fit[1] < 0.0) {
    noise.offset_m = right[0] / matrix(0, 0);
    noise.quadratic_per_m = 0.0;
  }
  if (noise.offset_m < perception::kLaserSigma_m) {
    noise.offset_m = perception::kLaserSigma_m;
    noise.quadratic_per_m =
        std::max(0.0, (right[1] - perception::kLaserSigma_m * matrix(0, 1)) / matrix(1, 1));
  }
  return noise;
}

bool differMuch(const RangeNoise& a, const RangeNoise& b) {
  for (const double distance : kCompared_m) {
    const double ratio = a.at(distance) / b.at(distance);
    if (ratio > 1.0 + kMuch || ratio < 1.0 / (1.0 + kMuch)) return true;
    if (std::abs(a.bias(distance) - b.bias(distance)) > kMuchBias * b.at(distance)) return true;
  }
  return false;
}

}  // namespace handmap
