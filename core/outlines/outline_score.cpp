#include "core/outlines/outline_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <type_traits>
#include <utility>

#include "core/base/quarter_octave.h"
#include "core/estimation/walls/constants.h"
#include "core/map/certainty.h"
#include "core/outlines/constants.h"

namespace handmap {

using namespace outlines;

namespace {

static_assert(kRates.size() == static_cast<std::size_t>(Likeness::Through));

const double kPassed = std::log(1.0 - kStopped);

/// log(1 − h Φ(z) + q N(z)) of a return z σ behind a wall, q = h r / (σ o): h the share of rays
/// that a wall stops, r how often it then looks as this one does, o how often other things along a
/// metre do. Tabulated over z and q, and beside it what a ray tells that got through.
class ReturnTable {
 public:
  ReturnTable() {
    std::ranges::transform(kRates, ratios_.begin(), [](const Rates& rates) {
      return static_cast<float>(kStopped * rates.of_walls / rates.of_others);
    });
    for (int level = least_; level <= most_; ++level) {
      const double ratio = middleOfQuarterOctave(level);
      addRow([&](double z) {
        const double behind = 0.5 * std::erfc(-z / std::numbers::sqrt2);
        const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * kPi);
        return std::log(1.0 - kStopped * behind + ratio * density);
      });
    }
    addRow([](double z) { return z < 0.5 * walls::kReach ? 0.0 : kPassed; });
  }

  float operator()(Likeness likeness, float z, float per_sigma) const {
    // The first and the last are for what is out of reach.
    const float column =
        std::clamp((z + walls::kReach) * steps_per_sigma_ + 1.0F, 0.0F, kTableSteps + 1.0F);
    const float ratio = ratios_[static_cast<std::size_t>(likeness)] * per_sigma;
    const int level =
        likeness == Likeness::Through ? most_ + 1 : std::clamp(quarterOctave(ratio), least_, most_);
    return table_[static_cast<std::size_t>((level - least_) * (kTableSteps + 2)) +
                  static_cast<std::size_t>(column)];
  }

 private:
  template <typename Value>
  void addRow(Value value) {
    table_.push_back(0.0F);
    for (int step = 0; step < kTableSteps; ++step) {
      const double z = (step + 0.5) / static_cast<double>(steps_per_sigma_) - walls::kReach;
      table_.push_back(static_cast<float>(value(z)));
    }
    table_.push_back(static_cast<float>(kPassed));
  }

  int least_ = quarterOctave(kLeastRatio);  ///< level of the first row
  int most_ = quarterOctave(kMostRatio);
  float steps_per_sigma_ = kTableSteps / (2.0F * walls::kReach);
  std::array<float, static_cast<std::size_t>(Likeness::Silent)> ratios_{};  ///< h r / o
  std::vector<float> table_;  ///< by level, and a row of what got through; by step, with both ends
};

float silentAt(float share) {
  return std::log(static_cast<float>(kSilentNear) + static_cast<float>(kSilentFar) * share);
}

struct Likenesses {
  Likeness along, askew;
};

Likenesses likenessesOf(const PlacedRay& ray, bool owned) {
  if (ray.echo == Echo::Silent) return {Likeness::Silent, Likeness::Silent};
  if (ray.echo == Echo::Ground || owned) return {Likeness::Through, Likeness::Through};
  if (ray.echo == Echo::Low) return {Likeness::Low, Likeness::Low};
  if (ray.structure == Structure::Straight) return {Likeness::Wall, Likeness::Askew};
  if (ray.structure == Structure::Linear) return {Likeness::Along, Likeness::Ragged};
  return {Likeness::Ragged, Likeness::Ragged};
}

struct Wall {
  float from_x, from_y, to_x, to_y;
  float nx, ny;  ///< normal, outwards
};

/// Wall i ends at corner i.
std::vector<Wall> wallsOf(const Polygon& outline) {
  std::vector<Wall> walls;
  Vec2 before = outline.back();
  for (const Vec2& corner : outline) {
    const Eigen::Vector2f from = before.cast<float>();
    const Eigen::Vector2f to = corner.cast<float>();
    const Eigen::Vector2f normal = -perpendicular(corner - before).normalized().cast<float>();
    walls.push_back({from.x(), from.y(), to.x(), to.y(), normal.x(), normal.y()});
    before = corner;
  }
  return walls;
}

struct Circle {
  Eigen::Vector2f middle;
  float radius;
};

Circle circleAround(const Polygon& outline) {
  Vec2 middle = Vec2::Zero();
  for (const Vec2& corner : outline) middle += corner / static_cast<double>(outline.size());
  double radius = 0.0;
  for (const Vec2& corner : outline) radius = std::max(radius, (corner - middle).norm());
  return {middle.cast<float>(), static_cast<float>(radius)};
}

using Indices = std::array<std::uint32_t, kBlock>;

/// Of those of the first `size` values that are at most `most`; returns their number.
std::size_t indicesUpTo(float most, const std::array<float, kBlock>& values, std::size_t size,
                        Indices& indices) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < size; ++k) {
    indices[count] = static_cast<std::uint32_t>(k);
    count += static_cast<std::size_t>(values[k] <= most);
  }
  return count;
}

}  // namespace

OutlineScorer::OutlineScorer(const PlacedRays& placed, double range_limit_m,
                             const RayOwners& owners, int building, const Vec2& centre,
                             double reach_m)
    : OutlineScorer(placed.noise, static_cast<float>(range_limit_m)) {
  const auto cx = static_cast<float>(centre.x());
  const auto cy = static_cast<float>(centre.y());
  const auto reach = static_cast<float>(reach_m);
  for (std::size_t f = 0; f + 1 < placed.frame_begin.size(); ++f) {
    if (placed.frame_begin[f] == placed.frame_begin[f + 1]) continue;
    const PlacedRay& first = placed.rays[placed.frame_begin[f]];
    if (std::hypot(cx - first.x, cy - first.y) > range_limit_m_ + reach) continue;
    for (std::size_t i = placed.frame_begin[f]; i < placed.frame_begin[f + 1]; ++i) {
      const PlacedRay& ray = placed.rays[i];
      const float forward = (cx - ray.x) * ray.dx + (cy - ray.y) * ray.dy;
      const float aside = std::abs((cx - ray.x) * ray.dy - (cy - ray.y) * ray.dx);
      if (aside > reach || forward < -reach || forward - reach > ray.range + 2.0F) continue;
      const bool owned = !owners.empty() && owners[i] != kNobody && owners[i] != building;
      const auto [along, askew] = likenessesOf(ray, owned);
      rays_.push_back({ray.range, ray.share, ray.nx, ray.ny, static_cast<std::uint32_t>(i), along,
                       askew, ray.echo == Echo::Tall, owned});
      x_.push_back(ray.x);
      y_.push_back(ray.y);
      dx_.push_back(ray.dx);
      dy_.push_back(ray.dy);
    }
    robots_.emplace_back(first.x, first.y);
  }
}

OutlineScorer OutlineScorer::thinned(std::size_t most) const {
  const std::size_t stride = 1 + rays_.size() / most;
  const auto thin = [stride](const auto& all) {
    std::decay_t<decltype(all)> some;
    some.reserve(all.size() / stride + 1);
    for (std::size_t i = 0; i < all.size(); i += stride) some.push_back(all[i]);
    return some;
  };
  OutlineScorer few(noise_, range_limit_m_);
  few.rays_ = thin(rays_);
  few.x_ = thin(x_);
  few.y_ = thin(y_);
  few.dx_ = thin(dx_);
  few.dy_ = thin(dy_);
  few.robots_ = robots_;
  few.each_ = each_ * static_cast<double>(stride);
  return few;
}

/// A ray meets a wall that faces it where it passes between its ends. Block by block and without
/// branches, so that some rays are reckoned at once.
template <typename Use>
void OutlineScorer::forMet(const Polygon& outline, Use use) const {
  const Circle around = circleAround(outline);
  const std::vector<Wall> walls = wallsOf(outline);
  Met::Each<float> aside, x, y, dx, dy, distance;
  Indices near, wall, in_range;
  Met met;
  for (std::size_t begin = 0; begin < rays_.size(); begin += kBlock) {
    const std::size_t size = std::min(kBlock, rays_.size() - begin);
    for (std::size_t k = 0; k < size; ++k) {
      aside[k] = std::abs((around.middle.x() - x_[begin + k]) * dy_[begin + k] -
                          (around.middle.y() - y_[begin + k]) * dx_[begin + k]);
    }
    const std::size_t passing = indicesUpTo(around.radius, aside, size, near);
    for (std::size_t k = 0; k < passing; ++k) {
      const std::size_t ray = begin + near[k];
      x[k] = x_[ray];
      y[k] = y_[ray];
      dx[k] = dx_[ray];
      dy[k] = dy_[ray];
      distance[k] = std::numeric_limits<float>::max();
      wall[k] = 0;
    }
    for (std::uint32_t w = 0; w < walls.size(); ++w) {
      const Wall& now = walls[w];
      for (std::size_t k = 0; k < passing; ++k) {
        const float from_x = now.from_x - x[k];
        const float from_y = now.from_y - y[k];
        const float to_x = now.to_x - x[k];
        const float to_y = now.to_y - y[k];
        const float left = dx[k] * from_y - dy[k] * from_x;
        const float right = dx[k] * to_y - dy[k] * to_x;
        const float area = from_x * to_y - from_y * to_x;
        const float there = area / (right - left);
        const float before = distance[k];
        const std::uint32_t wall_before = wall[k];
        const bool is_nearer = (left >= 0.0F) & (right <= 0.0F) & (area < 0.0F) & (there < before);
        distance[k] = is_nearer ? there : before;
        wall[k] = is_nearer ? w : wall_before;
      }
    }
    met.size = indicesUpTo(range_limit_m_, distance, passing, in_range);
    for (std::size_t n = 0; n < met.size; ++n) {
      const std::size_t k = in_range[n];
      const Wall& stopping = walls[wall[k]];
      met.ray[n] = static_cast<std::uint32_t>(begin) + near[k];
      met.range[n] = rays_[met.ray[n]].range;
      met.distance[n] = distance[k];
      met.cosine[n] = -(dx[k] * stopping.nx + dy[k] * stopping.ny);
      met.nx[n] = stopping.nx;
      met.ny[n] = stopping.ny;
      met.wall[n] = wall[k];
    }
    use(met);
  }
}

OutlineScorer::Met::Each<float> OutlineScorer::ratiosOf(const Met& met, double slack_m) const {
  static const ReturnTable kReturns;
  const auto offset = static_cast<float>(noise_.offset_m);
  const auto quadratic = static_cast<float>(noise_.quadratic_per_m);
  const auto slack = static_cast<float>(slack_m);
  Met::Each<float> variance, per_sigma, ratios;
  for (std::size_t k = 0; k < met.size; ++k) {
    const float own = offset + quadratic * met.distance[k] * met.distance[k];
    const float along = slack / std::max(met.cosine[k], kLeastCosine);
    variance[k] = own * own + along * along;
  }
  using All = Eigen::Map<Eigen::ArrayXf>;
  const auto size = static_cast<Eigen::Index>(met.size);
  All(per_sigma.data(), size) = All(variance.data(), size).sqrt().inverse();
  for (std::size_t k = 0; k < met.size; ++k) {
    const Asked& ray = rays_[met.ray[k]];
    const float parallel = std::abs(ray.nx * met.nx[k] + ray.ny * met.ny[k]);
    const Likeness likeness = parallel > kParallel ? ray.along : ray.askew;
    const float z = (met.range[k] - met.distance[k]) * per_sigma[k];
    ratios[k] =
        ray.share * (likeness == Likeness::Silent ? silentAt(met.distance[k] / range_limit_m_)
                                                  : kReturns(likeness, z, per_sigma[k]));
  }
  return ratios;
}

OutlineScorer::Evidence OutlineScorer::evidence(const Polygon& outline, double slack_m) const {
  Evidence evidence;
  for (const double nats : ofWalls(outline, slack_m)) {
    evidence.nats += nats;
    evidence.against += std::min(0.0, nats);
  }
  const Bounds bounds = boundsOf(outline);
  for (const Vec2& robot : robots_) {
    if (bounds.overlaps({robot, robot}) && contains(outline, robot)) evidence.nats -= kInside;
  }
  return evidence;
}

std::vector<double> OutlineScorer::ofWalls(const Polygon& outline, double slack_m) const {
  std::vector<double> scores(outline.size(), 0.0);
  forMet(outline, [&](const Met& met) {
    const auto ratios = ratiosOf(met, slack_m);
    for (std::size_t k = 0; k < met.size; ++k) {
      scores[met.wall[k]] += static_cast<double>(ratios[k]);
    }
  });
  for (double& score : scores) score *= kTemper * each_;
  return scores;
}

std::vector<double> OutlineScorer::returnsOf(const Polygon& outline, double slack_m) const {
  std::vector<double> returns(outline.size(), 0.0);
  forMet(outline, [&](const Met& met) {
    for (std::size_t k = 0; k < met.size; ++k) {
      const Asked& ray = rays_[met.ray[k]];
      if (ray.owned || !ray.tall) continue;
      const double noise = noise_.at(static_cast<double>(met.distance[k]));
      if (std::abs(met.behind(k)) > 2.0 * std::hypot(slack_m, noise)) continue;
      returns[met.wall[k]] += kTemper * static_cast<double>(ray.share);
    }
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
  forMet(outline, [&](const Met& met) {
    const auto ratios = ratiosOf(met, near_m);
    for (std::size_t k = 0; k < met.size; ++k) {
      const Asked& ray = rays_[met.ray[k]];
      if (ray.tall && std::abs(met.behind(k)) < near_m) standing.push_back({ray.index, ratios[k]});
    }
  });
  standing.shrink_to_fit();
  return standing;
}

double OutlineScorer::Standing::nats() const { return kTemper * static_cast<double>(ratio); }

int OutlineScorer::framesStandingFor(const Polygon& outline, double near_m) const {
  std::set<std::pair<float, float>> robots;
  forMet(outline, [&](const Met& met) {
    for (std::size_t k = 0; k < met.size; ++k) {
      const std::uint32_t ray = met.ray[k];
      if (!rays_[ray].tall || std::abs(met.behind(k)) >= near_m) continue;
      robots.emplace(x_[ray], y_[ray]);
    }
  });
  return static_cast<int>(robots.size());
}

}  // namespace handmap
