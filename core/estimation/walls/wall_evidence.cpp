#include "core/estimation/walls/wall_evidence.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/parallel.h"
#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

namespace {

/// std::lround() without a call.
std::int32_t fixedPoint(float ratio) {
  const double units = ratio * kScale;
  return static_cast<std::int32_t>(units + std::copysign(0.5, units));
}

/// In 2⁻³² of a cell: what is counted on in it costs neither a rounding nor a conversion.
std::int64_t fineCells(double cells) { return static_cast<std::int64_t>(cells * 0x1p32); }

}  // namespace

WallImage::WallImage(double heading_rad, double cell_m, double window_m)
    : heading_(heading_rad),
      cell_(cell_m),
      size_(static_cast<int>(std::bit_ceil(static_cast<unsigned>(window_m / cell_m)))),
      along_(unitVector(heading_rad)),
      across_(perpendicular(along_)),
      cells_(static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)) {}

void WallImage::clear() { std::fill(cells_.begin(), cells_.end(), 0); }

void WallImage::apply(const ActiveFrame& held, int sign) {
  const Pose2& pose = held.held_at;
  const SensorModel& sensor = *held.held_by;
  // Half a cell is what the grid itself is off.
  const double slack = 0.5 * cell_;
  const double along = along_.dot(pose.position());
  const double across = across_.dot(pose.position());
  const double turn = pose.heading - heading_;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const double first = std::ceil(across / cell_ - 0.5);
  std::int32_t* const cells = cells_.data();
  const auto cell_at = [cells, size = size_](std::int64_t column, int row) -> std::int32_t& {
    return cells[((column >> 32) & (size - 1)) * size + (row & (size - 1))];
  };
  const std::int32_t passed = sign * fixedPoint(sensor.passed());
  const std::int32_t silent = sign * fixedPoint(sensor.silent());
  for (const FrameRay& ray : held.frame->rays) {
    const double rise = s * ray.x + c * ray.y;
    if (rise < kGrazing) continue;
    const double run = c * ray.x - s * ray.y;
    const auto ray_slack = static_cast<float>(slack / rise);
    const bool is_silent = ray.sight.label == kSilent;
    double reach = ray.sight.range;
    double clear = ray.sight.range;  // farther than anything that the return may be of
    if (!is_silent) {
      const double around = 1.5 * sensor.reach(ray.sight.range);
      reach += around + 4.0 * ray_slack;
      clear -= around + 6.0 * ray_slack;
    }
    const double step = cell_ / rise;
    const std::int64_t column_step = fineCells(run / rise);
    auto row = static_cast<int>(first);
    double distance = ((first + 0.5) * cell_ - across) / rise;
    std::int64_t column = fineCells((along + distance * run) / cell_);
    for (; distance < clear; distance += step, column += column_step, ++row) {
      cell_at(column, row) += is_silent ? silent : passed;
    }
    for (; distance < reach; distance += step, column += column_step, ++row) {
      const float ratio = sensor(ray.sight, static_cast<float>(distance), ray_slack);
      cell_at(column, row) += sign * fixedPoint(ratio);
    }
  }
}

void WallEvidence::include(double heading, std::span<const ActiveFrame> held) {
  const std::size_t first = images_.size();
  for (int side = 0; side < 4; ++side) {
    images_.emplace_back(heading + side * kPi / 2.0, cell_, window_);
  }
  parallelFor(images_.size() - first, [&](std::size_t i) {
    for (const ActiveFrame& active : held) {
      images_[first + i].apply(active, 1);
    }
  });
}

void WallEvidence::exclude(double heading) {
  for (std::size_t i = 0; i < images_.size(); i += 4) {
    if (images_[i].heading() != heading) continue;
    const auto first = images_.begin() + static_cast<std::ptrdiff_t>(i);
    images_.erase(first, first + 4);
    return;
  }
}

void WallEvidence::putAnew(std::span<const ActiveFrame> held) {
  parallelFor(images_.size(), [&](std::size_t i) {
    images_[i].clear();
    for (const ActiveFrame& active : held) {
      images_[i].apply(active, 1);
    }
  });
}

void WallEvidence::change(std::span<const ActiveFrame> out, std::span<const ActiveFrame> in) {
  parallelFor(images_.size(), [&](std::size_t i) {
    for (const ActiveFrame& active : out) images_[i].apply(active, -1);
    for (const ActiveFrame& active : in) images_[i].apply(active, 1);
  });
}

}  // namespace handmap
