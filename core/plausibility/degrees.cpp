#include <array>
#include <cmath>
#include <complex>
#include <set>

#include "core/plausibility/checks.h"

namespace handmap {

namespace {

constexpr double kChord_m = 1.0;  // to either side of a pose: enough that noise is no degree
constexpr double kLongChord_m = 3.0;
constexpr double kStraight = 0.05;  // radians: where a robot bends it need not go where it looks
constexpr std::size_t kLeastHeadings = 20;
constexpr std::size_t kLeastDirections = 5;  // of 2° each; fewer might agree by chance
constexpr double kAgree = 0.6;   // 1: to the tenth of a degree; a real robot's 0.7 to 0.95
constexpr double kChance = 2.0;  // times what headings that are alike would agree by chance

struct Heading {
  double way;  ///< direction of the motion, radians
  double told;
};

/// Where the way is straight, half a metre apart.
std::vector<Heading> headingsOf(const std::vector<StampedPose>& poses) {
  std::vector<Heading> all;
  std::vector<double> way_m(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    way_m[i] = way_m[i - 1] + (poses[i].pose.position() - poses[i - 1].pose.position()).norm();
  }
  double last_m = -kChord_m;
  for (std::size_t i = 0, from = 0, to = 0; i < poses.size(); ++i) {
    while (from + 1 < i && way_m[i] - way_m[from + 1] >= kChord_m) ++from;
    while (to + 1 < poses.size() && way_m[to] - way_m[i] < kChord_m) ++to;
    const double before_m = way_m[i] - way_m[from];
    const double after_m = way_m[to] - way_m[i];
    const auto fits = [](double m) { return m >= kChord_m && m < kLongChord_m; };
    if (!fits(before_m) || !fits(after_m) || way_m[i] - last_m < 0.5 * kChord_m) continue;
    const Vec2 before = poses[i].pose.position() - poses[from].pose.position();
    const Vec2 after = poses[to].pose.position() - poses[i].pose.position();
    const double bend =
        normalizedAngle(std::atan2(after.y(), after.x()) - std::atan2(before.y(), before.x()));
    if (std::abs(bend) > kStraight) continue;
    all.push_back({std::atan2(before.y(), before.x()) + 0.5 * bend, poses[i].pose.heading});
    last_m = way_m[i];
  }
  return all;
}

/// 1: to the letter, 0: by chance.
double agreementInDegrees(const std::vector<Heading>& all, double from, double sign) {
  std::array<std::complex<double>, 3> sums{};
  double counted = sign * (all.front().way - from);
  for (const Heading& heading : all) {
    const double way = normalizedAngle(sign * (heading.way - from));
    counted += normalizedAngle(way - counted);
    const std::array ways{way, way < 0.0 ? way + 2.0 * kPi : way, counted};
    for (std::size_t i = 0; i < ways.size(); ++i) {
      sums.at(i) += std::polar(1.0, toDegrees(ways.at(i)) - heading.told);
    }
  }
  double most = 0.0;
  for (const auto& sum : sums) most = std::max(most, std::abs(sum));
  return most / static_cast<double>(all.size());
}

}  // namespace

bool lookLikeDegrees(const std::vector<StampedPose>& poses) {
  const std::vector<Heading> all = headingsOf(poses);
  std::complex<double> told;
  std::set<int> directions;
  for (const Heading& heading : all) {
    told += std::polar(1.0, heading.told);
    directions.insert(static_cast<int>(std::floor(toDegrees(normalizedAngle(heading.way)) / 2.0)));
  }
  if (all.size() < kLeastHeadings || directions.size() < kLeastDirections) return false;
  const double alike = std::norm(told / static_cast<double>(all.size()));
  const double least = std::max(kAgree, kChance * alike);
  // From x or from y, counter-clockwise or clockwise, from -180° or from 0° on or over whole turns.
  for (const double from : {0.0, kPi / 2}) {
    for (const double sign : {1.0, -1.0}) {
      if (agreementInDegrees(all, from, sign) > least) return true;
    }
  }
  return false;
}

}  // namespace handmap
