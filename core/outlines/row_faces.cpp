#include "core/outlines/row_faces.h"

#include <algorithm>
#include <cmath>

#include "core/outlines/constants.h"
#include "core/outlines/row_division.h"

namespace handmap {

using namespace outlines;

RowFaces::RowFaces(const PlacedRays& placed, const RowBand& band)
    : band_(band),
      cells_(std::max(1, static_cast<int>(std::ceil((band.to - band.from) / kRowCell_m)))),
      depths_(std::max(1, static_cast<int>(std::ceil((band.high - band.low) / kFaceDepth_m)))) {
  const Vec2 along = unitVector(band.heading);
  const Vec2 across = perpendicular(along);
  const auto size = static_cast<std::size_t>(depths_ * (cells_ + 1));
  for (auto& sums : sums_) sums.assign(size, 0.0);
  for (auto& seen : seen_) seen.assign(static_cast<std::size_t>(cells_ + 1), 0);
  returns_.assign(static_cast<std::size_t>(cells_), 0);
  const double middle = 0.5 * (band.low + band.high);
  Vec2 direction = Vec2::Zero();
  // Returns by cell, first where sums will be.
  for (const PlacedRay& ray : placed.rays) {
    if (const auto cell = crossed(ray, along, across, middle)) --returns_[*cell];
    if (ray.echo != Echo::Tall) continue;
    const Vec2 end = ray.end();
    const double x = along.dot(end);
    const double y = across.dot(end);
    if (x < band.from || x >= band.to || y < band.low || y >= band.high) continue;
    const int cell = std::min(cellOf(x), cells_ - 1);
    ++returns_[static_cast<std::size_t>(cell)];
    const Vec2 normal(static_cast<double>(ray.nx), static_cast<double>(ray.ny));
    if (ray.structure != Structure::Straight || std::abs(normal.dot(across)) < kParallel) continue;
    const Vec2 robot(static_cast<double>(ray.x), static_cast<double>(ray.y));
    direction += std::copysign(1.0, normal.dot(across)) * normal;
    const Face face = across.dot(robot) < y ? kLow : kHigh;
    sum(face, static_cast<int>((y - band.low) / kFaceDepth_m), cell + 1) += 1.0;
  }
  if (!direction.isZero()) turn_ = std::atan2(cross(across, direction), across.dot(direction));
  const int reach = static_cast<int>(std::lround(kSlack_m / kFaceDepth_m));
  for (const Face face : {kLow, kHigh}) {
    std::vector<double> nearer(static_cast<std::size_t>(depths_ + 1));  // across, than a depth
    for (int cell = 0; cell < cells_; ++cell) {
      for (int d = 0; d < depths_; ++d) {
        const auto depth = static_cast<std::size_t>(d);
        nearer[depth + 1] = nearer[depth] + sum(face, d, cell + 1);
      }
      const double all = nearer.back();
      const bool seen = all >= kFaceReturns;
      seen_[face][static_cast<std::size_t>(cell + 1)] =
          seen_[face][static_cast<std::size_t>(cell)] + (seen ? 1 : 0);
      for (int d = 0; d < depths_; ++d) {
        const double low = nearer[static_cast<std::size_t>(std::max(0, d - reach))];
        const double high = nearer[static_cast<std::size_t>(std::min(depths_, d + reach + 1))];
        const double before = face == kLow ? low : all - high;
        const double share = (high - low + kBeforeFace * before) / all;
        const double nats = seen ? kFaceTemper * std::log(1.0 - kStopped + kStopped * share) : 0.0;
        sum(face, d, cell + 1) = sum(face, d, cell) + nats;
      }
    }
    if (seen_[face].back() > 0) whole_[face] = best(face, 0, cells_).depth;
  }
}

double RowFaces::evidence(double from, double to) const {
  return best(kLow, cellOf(from), cellOf(to)).nats + best(kHigh, cellOf(from), cellOf(to)).nats;
}

std::optional<double> RowFaces::across(Face face, double from, double to) const {
  const int a = cellOf(from);
  const int b = cellOf(to);
  const auto& seen = seen_[face];
  if (seen[static_cast<std::size_t>(a)] == seen[static_cast<std::size_t>(b)]) return std::nullopt;
  return band_.low + (best(face, a, b).depth + 0.5) * kFaceDepth_m;
}

std::pair<double, double> RowFaces::seenAround(double from, double to) const {
  const int gap = static_cast<int>(kWallToWall_m / kRowCell_m);
  const int at_from = cellOf(from);
  const int at_to = cellOf(to);
  int all = 0;
  for (int c = at_from; c < at_to; ++c) all += std::max(0, returns_[static_cast<std::size_t>(c)]);
  const double least = kWallShare * all / std::max(1, at_to - at_from);
  const auto is_wall = [&](int cell) { return returns_[static_cast<std::size_t>(cell)] > least; };
  int first = at_from;
  int last = at_to;
  for (int c = first - 1; c >= std::max(0, first - gap); --c) {
    if (is_wall(c)) first = c;
  }
  for (int c = last + 1; c < std::min(cells_, last + 1 + gap); ++c) {
    if (is_wall(c)) last = c;
  }
  return {first < at_from ? band_.from + first * kRowCell_m : from,
          last > at_to ? band_.from + (last + 1) * kRowCell_m : to};
}

/// Where it goes through.
std::optional<std::size_t> RowFaces::crossed(const PlacedRay& ray, const Vec2& along,
                                             const Vec2& across, double middle) const {
  const Vec2 robot(static_cast<double>(ray.x), static_cast<double>(ray.y));
  const Vec2 direction(static_cast<double>(ray.dx), static_cast<double>(ray.dy));
  const double reach = (middle - across.dot(robot)) / across.dot(direction);
  if (!(reach > 0.0 && reach < static_cast<double>(ray.range))) return std::nullopt;
  const double x = along.dot(robot + reach * direction);
  if (x < band_.from || x >= band_.to) return std::nullopt;
  return static_cast<std::size_t>(std::min(cellOf(x), cells_ - 1));
}

int RowFaces::cellOf(double along) const {
  return std::clamp(static_cast<int>((along - band_.from) / kRowCell_m + 1e-6), 0, cells_);
}

RowFaces::Best RowFaces::best(Face face, int from, int to) const {
  Best most{-1e300, 0};
  for (int d = 0; d < depths_; ++d) {
    const double step = whole_[face] ? (d - *whole_[face]) * kFaceDepth_m / kFaceStep_m : 0.0;
    const double nats = sum(face, d, to) - sum(face, d, from) - 0.5 * step * step;
    if (nats > most.nats) most = {nats, d};
  }
  return most;
}

double& RowFaces::sum(Face face, int depth, int cell) {
  return sums_[face][static_cast<std::size_t>(cell * depths_ + depth)];
}
double RowFaces::sum(Face face, int depth, int cell) const {
  return sums_[face][static_cast<std::size_t>(cell * depths_ + depth)];
}

}  // namespace handmap
