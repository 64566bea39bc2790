#include "core/outlines/outline_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/estimation/walls/constants.h"
#include "core/map/certainty.h"
#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

static_assert(kRates.size() == static_cast<std::size_t>(Likeness::Count));

ReturnTable::ReturnTable() {
  table_.resize(static_cast<std::size_t>(kTableRatios * kTableSteps));
  for (int k = 0; k < kTableRatios; ++k) {
    const double ratio = kLeastRatio * std::pow(kMostRatio / kLeastRatio, k / (kTableRatios - 1.0));
    for (int i = 0; i < kTableSteps; ++i) {
      const double z = static_cast<double>(walls::kReach) * (2.0 * (i + 0.5) / kTableSteps - 1.0);
      const double behind = 0.5 * std::erfc(-z / std::numbers::sqrt2);
      const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi);
      table_[static_cast<std::size_t>(k * kTableSteps + i)] =
          static_cast<float>(std::log(1.0 - kStopped * behind + ratio * density));
    }
  }
}

float ReturnTable::operator()(Likeness likeness, float z, float sigma_m) const {
  if (z <= -walls::kReach) return 0.0F;
  static const auto kPassed = static_cast<float>(std::log(1.0 - kStopped));
  if (z >= walls::kReach) return kPassed;
  const Rates& rates = kRates[static_cast<std::size_t>(likeness)];
  const auto ratio = static_cast<float>(kStopped * rates.of_walls / rates.of_others) / sigma_m;
  static const auto kPerRatio =
      static_cast<float>((kTableRatios - 1.0) / std::log2(kMostRatio / kLeastRatio));
  static const auto kLow = static_cast<float>(std::log2(kLeastRatio)) - 0.5F / kPerRatio;
  const int k =
      std::clamp(static_cast<int>((std::log2(ratio) - kLow) * kPerRatio), 0, kTableRatios - 1);
  const int i = std::clamp(static_cast<int>((z / walls::kReach + 1.0F) * 0.5F * kTableSteps), 0,
                           kTableSteps - 1);
  return table_[static_cast<std::size_t>(k * kTableSteps + i)];
}

OutlineScorer::OutlineScorer(const PlacedRays& placed, double range_limit_m,
                             const RayOwners& owners, int building, const Vec2& centre,
                             double reach_m)
    : noise_(placed.noise), range_limit_m_(static_cast<float>(range_limit_m)) {
  const auto cx = static_cast<float>(centre.x());
  const auto cy = static_cast<float>(centre.y());
  const auto reach = static_cast<float>(reach_m);
  for (std::size_t f = 0; f + 1 < placed.frame_begin.size(); ++f) {
    if (placed.frame_begin[f] == placed.frame_begin[f + 1]) continue;
    const PlacedRay& first = placed.rays[placed.frame_begin[f]];
    if (std::hypot(cx - first.x, cy - first.y) > range_limit_m_ + reach) continue;
    for (std::size_t i = placed.frame_begin[f]; i < placed.frame_begin[f + 1]; ++i) {
      const PlacedRay& ray = placed.rays[i];
      const float along = (cx - ray.x) * ray.dx + (cy - ray.y) * ray.dy;
      const float aside = std::abs((cx - ray.x) * ray.dy - (cy - ray.y) * ray.dx);
      if (aside > reach || along < -reach || along - reach > ray.range + 2.0F) continue;
      const bool owned = !owners.empty() && owners[i] != kNobody && owners[i] != building;
      rays_.push_back({ray, i, owned});
      directions_.push_back({ray.dx, ray.dy});
    }
    frames_.push_back(
        {Vec2(static_cast<double>(first.x), static_cast<double>(first.y)), rays_.size()});
  }
}

/// All rays of a frame begin at one point, so that what a wall is to them is the same for all: a
/// ray meets a wall that faces the robot where it passes between its ends.
template <typename Use>
void OutlineScorer::forMet(const Polygon& outline, std::size_t stride, Use use) const {
  struct Wall {
    float from_x, from_y, to_x, to_y;  // ends, as the robot has them
    float along_x, along_y;
    float area;  // twice that of the triangle with the robot; negative
    std::size_t index;
  };
  std::vector<Wall> walls;
  walls.reserve(outline.size());
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : outline) middle += corner / static_cast<double>(outline.size());
  double radius = 0.0;
  std::vector<Eigen::Vector2f> corners;
  corners.reserve(outline.size());
  for (const Vec2& corner : outline) {
    radius = std::max(radius, (corner - middle).norm());
    corners.push_back(corner.cast<float>());
  }
  const auto within = static_cast<float>(radius);
  std::size_t ray = 0;
  for (const Frame& frame : frames_) {
    if (ray >= frame.end) continue;
    const Eigen::Vector2f robot = frame.robot.cast<float>();
    const Eigen::Vector2f there = middle.cast<float>() - robot;
    walls.clear();
    Eigen::Vector2f from = corners.back() - robot;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2f to = corners[i] - robot;
      const float area = from.x() * to.y() - from.y() * to.x();
      if (area < 0.0F) {
        walls.push_back(
            {from.x(), from.y(), to.x(), to.y(), to.x() - from.x(), to.y() - from.y(), area, i});
      }
      from = to;
    }
    for (; ray < frame.end; ray += stride) {
      const Direction& d = directions_[ray];
      if (std::abs(there.x() * d.y - there.y() * d.x) > within) continue;
      const Wall* met = nullptr;
      float nearest = std::numeric_limits<float>::max();
      for (const Wall& wall : walls) {
        if (d.x * wall.to_y > d.y * wall.to_x || d.x * wall.from_y < d.y * wall.from_x) continue;
        const float distance = wall.area / (d.x * wall.along_y - d.y * wall.along_x);
        if (!(distance < nearest)) continue;
        nearest = distance;
        met = &wall;
      }
      if (met == nullptr) continue;
      const float length = std::sqrt(met->along_x * met->along_x + met->along_y * met->along_y);
      const float nx = met->along_y / length;
      const float ny = -met->along_x / length;
      use(rays_[ray], Met{nearest, -(d.x * nx + d.y * ny), nx, ny, met->index});
    }
  }
}

float OutlineScorer::ratioOf(const Asked& asked, const Met& met, float slack_m) const {
  const PlacedRay& ray = asked.ray;
  if (met.distance > range_limit_m_) return 0.0F;
  static const auto kPassed = static_cast<float>(std::log(1.0 - kStopped));
  if (ray.echo == Echo::Silent) {
    return static_cast<float>(
        std::log(kSilentNear + kSilentFar * static_cast<double>(met.distance / range_limit_m_)));
  }
  const float slack = slack_m / std::max(met.cosine, kLeastCosine);
  const auto own = static_cast<float>(noise_.at(static_cast<double>(met.distance)));
  const float sigma = std::sqrt(own * own + slack * slack);
  const float z = (ray.range - met.distance) / sigma;
  if (ray.echo == Echo::Ground || asked.owned) {
    return z <= -walls::kReach ? 0.0F : z >= walls::kReach / 2.0F ? kPassed : 0.0F;
  }
  Likeness likeness = Likeness::Ragged;
  const bool parallel = std::abs(ray.nx * met.nx + ray.ny * met.ny) > kParallel;
  if (ray.echo == Echo::Low) {
    likeness = Likeness::Low;
  } else if (ray.structure == Structure::Straight) {
    likeness = parallel ? Likeness::Wall : Likeness::Askew;
  } else if (ray.structure == Structure::Linear && parallel) {
    likeness = Likeness::Along;
  }
  return table_(likeness, z, sigma);
}

double OutlineScorer::operator()(const Polygon& outline, double slack_m, std::size_t stride) const {
  double score = 0.0;
  const auto slack = static_cast<float>(slack_m);
  forMet(outline, stride, [&](const Asked& asked, const Met& met) {
    score += static_cast<double>(asked.ray.share * ratioOf(asked, met, slack));
  });
  score *= kTemper * static_cast<double>(stride);
  const Bounds bounds = boundsOf(outline);
  for (const Frame& frame : frames_) {
    const Vec2& robot = frame.robot;
    if ((robot.array() > bounds.low.array()).all() && (robot.array() < bounds.high.array()).all() &&
        contains(outline, robot)) {
      score -= kInside;
    }
  }
  return score;
}

std::vector<double> OutlineScorer::returnsOf(const Polygon& outline, double slack_m) const {
  std::vector<double> returns(outline.size(), 0.0);
  forMet(outline, 1, [&](const Asked& asked, const Met& met) {
    if (asked.owned || asked.ray.echo != Echo::Tall) return;
    const double error = static_cast<double>((asked.ray.range - met.distance) * met.cosine);
    const double noise = noise_.at(static_cast<double>(met.distance));
    if (std::abs(error) > 2.0 * std::hypot(slack_m, noise)) return;
    returns[met.wall] += kTemper * static_cast<double>(asked.ray.share);
  });
  return returns;
}

std::array<double, 4> OutlineScorer::returnsOfSides(const Polygon& outline, double heading,
                                                    double slack_m) const {
  const std::vector<double> returns = returnsOf(outline, slack_m);
  std::array<double, 4> of_side{};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 along = outline[i] - outline[(i + outline.size() - 1) % outline.size()];
    of_side[sideFacing(heading, -perpendicular(along))] += returns[i];
  }
  return of_side;
}

std::vector<OutlineScorer::Standing> OutlineScorer::standingFor(const Polygon& outline,
                                                                double near_m) const {
  std::vector<Standing> standing;
  forMet(outline, 1, [&](const Asked& asked, const Met& met) {
    const double error = static_cast<double>((asked.ray.range - met.distance) * met.cosine);
    if (asked.ray.echo != Echo::Tall || std::abs(error) >= near_m) return;
    const float ratio = ratioOf(asked, met, static_cast<float>(near_m));
    standing.push_back({static_cast<std::uint32_t>(asked.index), asked.ray.share * ratio});
  });
  standing.shrink_to_fit();
  return standing;
}

double OutlineScorer::Standing::nats() const { return kTemper * static_cast<double>(ratio); }

int OutlineScorer::framesStandingFor(const Polygon& outline, double near_m) const {
  std::set<std::pair<float, float>> robots;
  forMet(outline, 1, [&](const Asked& asked, const Met& met) {
    const double error = static_cast<double>((asked.ray.range - met.distance) * met.cosine);
    if (asked.ray.echo != Echo::Tall || std::abs(error) >= near_m) return;
    robots.emplace(asked.ray.x, asked.ray.y);
  });
  return static_cast<int>(robots.size());
}

}  // namespace handmap
