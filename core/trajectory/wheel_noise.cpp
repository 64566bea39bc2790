#include "core/trajectory/wheel_noise.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/median.h"
#include "core/odometry/constants.h"
#include "core/trajectory/constants.h"
#include "core/trajectory/scan_noise.h"

namespace handmap {

using namespace trajectory;

namespace {

double median(const std::deque<double>& values) {
  return medianOf(std::vector<double>(values.begin(), values.end()));
}

void remember(std::deque<double>& values, double value, std::size_t most) {
  values.push_back(value);
  if (values.size() > most) values.pop_front();
}

double learntScale(const std::deque<double>& deviations, double least, double most) {
  return std::clamp(kPulled * median(deviations), least, most);
}

}  // namespace

WheelNoise WheelNoise::ofGuesses() {
  WheelNoise noise;
  noise.learns_ = false;
  noise.move_ = kGuessedMove;
  noise.aside_ = kGuessedAside;
  noise.turn_ = kGuessedTurn;
  return noise;
}

Eigen::Vector3d WheelNoise::sigma(const Pose2& recorded) const {
  return kWheels.sigmaOf(recorded).cwiseProduct(Eigen::Vector3d(move_, aside_, turn_));
}

MotionFactor WheelNoise::factor(const Pose2& recorded) const {
  return {{length_ * recorded.x, length_ * recorded.y, recorded.heading},
          sigma(recorded).cwiseInverse().asDiagonal()};
}

void WheelNoise::learn(const Pose2& recorded, const Pose2& matched, double least) {
  if (!learns_) return;
  const Eigen::Vector3d sigma = kWheels.sigmaOf(recorded);
  const Vec2 off = matched.position() - length_ * recorded.position();
  remember(move_deviations_, std::abs(off.x()) / sigma.x(), kDeviations);
  remember(turn_deviations_,
           std::abs(normalizedAngle(matched.heading - recorded.heading)) / sigma.z(), kDeviations);
  const double length = recorded.position().norm();
  if (length > perception::kMoved_m) remember(ratios_, matched.position().norm() / length, kRatios);
  if (move_deviations_.size() >= kLeastDeviations) {
    move_ = learntScale(move_deviations_, least, kMostMoveScale);
    aside_ = move_;
    turn_ = learntScale(turn_deviations_, least, kMostTurnScale);
  }
  if (ratios_.size() >= kLeastRatios) length_ = median(ratios_);
}

}  // namespace handmap
