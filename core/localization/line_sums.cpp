#include "core/localization/line_sums.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace handmap {

namespace {

constexpr double kOne = 65536.0;  // fixed point, 16 bits of fraction

std::int32_t fixed(double value) { return static_cast<std::int32_t>(std::lround(value * kOne)); }

}  // namespace

void LineSums::reset(const LocalMap& local_map) {
  const bool same_size = local_map.cell() == cell_ && local_map.cells().size() == cells_.size();
  cells_ = local_map.cells();
  if (!same_size) resize(local_map);
  for (std::size_t direction = 0; direction < used_.size(); ++direction) {
    if (!used_[direction].exchange(false, std::memory_order_relaxed)) continue;
    for (std::size_t row = 0; row < rows_; ++row) {
      slots_[direction * rows_ + row].store(nullptr, std::memory_order_relaxed);
    }
  }
  for (RowMemory& memory : memory_) memory.release();
}

void LineSums::resize(const LocalMap& local_map) {
  cell_ = local_map.cell();
  origin_ = fixed(local_map.range() / cell_);
  // One cell inside the edge of the grid, so that rounding never leads out of it.
  radius_ = std::max(0, static_cast<int>(local_map.range() / cell_ - 1.0));
  rows_ = 2 * static_cast<std::size_t>(radius_);
  half_.clear();
  for (int row = -radius_; row < radius_; ++row) {
    const double lateral = row + 0.5;
    half_.push_back(static_cast<int>(
        std::lround(std::sqrt(radius_ * static_cast<double>(radius_) - lateral * lateral))));
  }
  const auto longest = static_cast<std::uint32_t>(rows_);
  sum_bits_ = 32U - static_cast<std::uint32_t>(std::bit_width(longest));
  sum_mask_ = (1U << sum_bits_) - 1U;
  unit_ = 1.0F / static_cast<float>(std::min(65535U, sum_mask_ / std::max(1U, longest)));
  slots_ = std::make_unique<std::atomic<const std::uint32_t*>[]>(LineDirection::kHalfTurn * rows_);
}

const std::uint32_t* LineSums::read(std::size_t direction, std::size_t row) const {
  const Vec2 step = unitVector(static_cast<double>(direction) * LineDirection::kStep);
  const int half = half_[row];
  const Vec2 from =
      step * (0.5 - half) + perpendicular(step) * (static_cast<double>(row) + 0.5 - radius_);
  std::int32_t x = fixed(from.x()) + origin_;
  std::int32_t y = fixed(from.y()) + origin_;
  const std::int32_t dx = fixed(step.x());
  const std::int32_t dy = fixed(step.y());

  const std::size_t count = 2 * static_cast<std::size_t>(half) + 1;
  RowMemory& memory = memory_.local();
  std::uint32_t* sums = memory.take(count);
  const float* values = cells_.ptr<float>();
  const int stride = static_cast<int>(cells_.step1());
  const std::uint32_t one = 1U << sum_bits_;
  const float scale = 1.0F / unit_;
  std::uint32_t sum = 0;
  sums[0] = 0;
  for (std::size_t i = 1; i < count; ++i, x += dx, y += dy) {
    const float value = values[(y >> 16) * stride + (x >> 16)];
    const auto units = static_cast<std::int32_t>(std::min(value, 1.0F) * scale + 0.5F);
    sum += static_cast<std::uint32_t>(units) + (value > 0.0F ? one : 0);
    sums[i] = sum;
  }

  used_[direction].store(true, std::memory_order_relaxed);
  const std::uint32_t* other = nullptr;
  auto& slot = slots_[direction * rows_ + row];
  if (slot.compare_exchange_strong(other, sums, std::memory_order_acq_rel)) return sums;
  memory.giveBack(count);
  return other;
}

}  // namespace handmap
