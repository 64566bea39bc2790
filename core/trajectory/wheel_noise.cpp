#include "core/trajectory/wheel_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/odometry/odometry_noise.h"
#include "core/trajectory/scan_noise.h"

namespace handmap {

namespace {

constexpr std::size_t kDeviations = 80;
constexpr std::size_t kLeastDeviations = 10;
constexpr std::size_t kRatios = 300;
constexpr std::size_t kLeastRatios = 40;
constexpr double kRatioMotion_m = 0.3;  // shorter ones tell no length
constexpr double kPulled = 1.6;         // a match lies between the odometry and what the scan says
constexpr double kLeast = 0.7;
constexpr double kMostTurn = 6.0;
constexpr double kMostMove = 4.0;

double median(const std::deque<double>& values) {
  std::vector<double> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

void remember(std::deque<double>& values, double value, std::size_t most) {
  values.push_back(value);
  if (values.size() > most) values.pop_front();
}

double learntScale(const std::deque<double>& deviations, double most) {
  return std::clamp(kPulled * kMedianToSigma * median(deviations), kLeast, most);
}

}  // namespace

WheelNoise WheelNoise::ofGuesses() {
  // As measured on a campus and in simulated quarters, scans a metre apart: within a third of each
  // the way is off by a tenth to a quarter of what it is with three times as much.
  constexpr double kMove = 10.0;   // 0.1 m and 30 % of the way: it keeps its speed
  constexpr double kAside = 3.0;   // 0.03 m and 3 %: it drives where it looks
  constexpr double kTurn = 150.0;  // 9° and more the farther
  WheelNoise noise;
  noise.learns_ = false;
  noise.move_ = kMove;
  noise.aside_ = kAside;
  noise.turn_ = kTurn;
  return noise;
}

Eigen::Vector3d WheelNoise::sigma(const Pose2& recorded) const {
  return kWheels.sigmaOf(recorded).cwiseProduct(Eigen::Vector3d(move_, aside_, turn_));
}

MotionFactor WheelNoise::factor(const Pose2& recorded) const {
  return {{length_ * recorded.x, length_ * recorded.y, recorded.heading},
          sigma(recorded).cwiseInverse().asDiagonal()};
}

void WheelNoise::learn(const Pose2& recorded, const Pose2& matched) {
  if (!learns_) return;
  const Eigen::Vector3d sigma = kWheels.sigmaOf(recorded);
  const Vec2 off = matched.position() - length_ * recorded.position();
  remember(move_deviations_, std::abs(off.x()) / sigma.x(), kDeviations);
  remember(turn_deviations_,
           std::abs(normalizedAngle(matched.heading - recorded.heading)) / sigma.z(), kDeviations);
  const double length = recorded.position().norm();
  if (length > kRatioMotion_m) remember(ratios_, matched.position().norm() / length, kRatios);
  if (move_deviations_.size() >= kLeastDeviations) {
    move_ = learntScale(move_deviations_, kMostMove);
    aside_ = move_;
    turn_ = learntScale(turn_deviations_, kMostTurn);
  }
  if (ratios_.size() >= kLeastRatios) length_ = median(ratios_);
}

}  // namespace handmap
