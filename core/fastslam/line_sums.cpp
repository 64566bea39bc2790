#include "core/fastslam/line_sums.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/parallel.h"

namespace handmap {

namespace {

constexpr double kOne = 65536.0;  // fixed point, 16 bits of fraction
constexpr float kHalf = 0.5F;     // rounds what is not negative

std::int32_t fixed(double value) { return static_cast<std::int32_t>(std::lround(value * kOne)); }

}  // namespace

std::vector<Vec2> LineSums::unitVectors() {
  std::vector<Vec2> units;
  for (int index = 0; index < LineDirection::kHalfTurn; ++index) {
    units.push_back(unitVector(index * LineDirection::kStep));
  }
  return units;
}

void LineSums::reset(const LocalMap& local_map) {
  if (local_map.cell() != cell_ || local_map.cells().cols != stride_) resize(local_map);
  for (std::size_t direction = 0; direction < used_.size(); ++direction) {
    if (!used_[direction].exchange(false, std::memory_order_relaxed)) continue;
    for (std::size_t row = 0; row < rows_; ++row) {
      slots_[direction * rows_ + row].store(nullptr, std::memory_order_relaxed);
    }
  }
  for (RowMemory& memory : memory_) memory.release();
  parallelFor(static_cast<std::size_t>(blocks_),
              [&](std::size_t row) { takeBlocks(local_map.cells(), static_cast<int>(row)); });
  // A stretch that has its middle in a block lies in that and the eight around it.
  cv::dilate(hit_, near_hit_, cv::Mat(), {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
}

/// Packs one row of blocks; those that were and are empty are passed over.
void LineSums::takeBlocks(const cv::Mat1f& cells, int row) {
  const int first_y = row * kBlock;
  const int last_y = std::min(first_y + kBlock, stride_);
  std::vector<std::uint8_t> any(static_cast<std::size_t>(stride_));
  for (int y = first_y; y < last_y; ++y) {
    const float* from = cells.ptr<float>(y);
    for (std::size_t x = 0; x < any.size(); ++x) {
      any[x] |= static_cast<std::uint8_t>(from[x] > 0.0F);
    }
  }
  const float scale = 1.0F / unit_;
  const std::uint32_t one = 1U << sum_bits_;
  std::uint8_t* hit = hit_.ptr(row + 1) + 1;
  for (int block = 0; block < blocks_; ++block) {
    const int first_x = block * kBlock;
    const int last_x = std::min(first_x + kBlock, stride_);
    const bool before = hit[block] != 0;
    hit[block] = *std::max_element(any.begin() + first_x, any.begin() + last_x);
    if (!before && hit[block] == 0) continue;
    for (int y = first_y; y < last_y; ++y) {
      const float* from = cells.ptr<float>(y);
      std::uint32_t* to = packed_.data() + static_cast<std::ptrdiff_t>(y) * stride_;
      for (int x = first_x; x < last_x; ++x) {
        const auto units = static_cast<std::int32_t>(std::min(from[x], 1.0F) * scale + kHalf);
        to[x] = static_cast<std::uint32_t>(units) + (from[x] > 0.0F ? one : 0U);
      }
    }
  }
}

void LineSums::resize(const LocalMap& local_map) {
  cell_ = local_map.cell();
  stride_ = local_map.cells().cols;
  packed_.assign(local_map.cells().total(), 0);
  blocks_ = (stride_ + kBlock - 1) / kBlock;
  hit_ = cv::Mat1b(blocks_ + 2, blocks_ + 2, std::uint8_t{0});
  origin_ = fixed(local_map.range() / cell_);
  // One cell inside the edge of the grid, so that rounding never leads out of it.
  radius_ = std::max(0, static_cast<int>(local_map.range() / cell_ - 1.0));
  rows_ = 2 * static_cast<std::size_t>(radius_);
  half_.clear();
  for (int row = -radius_; row < radius_; ++row) {
    const double lateral = row + 0.5;
    const double half = std::sqrt(radius_ * static_cast<double>(radius_) - lateral * lateral);
    half_.push_back(2 * static_cast<int>(std::lround(half / 2.0)));  // whole stretches in a row
  }
  const auto longest = static_cast<std::uint32_t>(rows_) + 2U;
  sum_bits_ = 32U - static_cast<std::uint32_t>(std::bit_width(longest));
  sum_mask_ = (1U << sum_bits_) - 1U;
  unit_ = 1.0F / static_cast<float>(std::min(65535U, sum_mask_ / std::max(1U, longest)));
  slots_ = std::make_unique<std::atomic<const std::uint32_t*>[]>(LineDirection::kHalfTurn * rows_);
}

const std::uint32_t* LineSums::read(std::size_t direction, std::size_t row) const {
  const Vec2& step = units_[direction];
  const int half = half_[row];
  const Vec2 from =
      step * (0.5 - half) + perpendicular(step) * (static_cast<double>(row) + 0.5 - radius_);
  std::int32_t x = fixed(from.x()) + origin_;
  std::int32_t y = fixed(from.y()) + origin_;
  const std::int32_t dx = fixed(step.x());
  const std::int32_t dy = fixed(step.y());

  const std::size_t count = static_cast<std::size_t>(2 * half / kStretch) + 2;
  RowMemory& memory = memory_.local();
  std::uint32_t* sums = memory.take(count);
  const std::uint32_t* packed = packed_.data();
  const int stride = stride_;
  const std::uint8_t* near = near_hit_.ptr(1) + 1;
  const int near_stride = near_hit_.cols;
  std::uint32_t sum = 0;
  std::uint32_t* to = sums;
  for (int left = 2 * half; left > 0; left -= kBlock) {
    const int block_x = (x + dx * (kBlock / 2)) >> (16 + kBlockBits);
    const int block_y = (y + dy * (kBlock / 2)) >> (16 + kBlockBits);
    const bool hit = near[block_y * near_stride + block_x] != 0;
    for (int i = 0; i < std::min(kBlock, left); i += kStretch) {
      *to++ = sum;
      for (int j = 0; hit && j < kStretch; ++j) {
        sum += packed[((y + j * dy) >> 16) * stride + ((x + j * dx) >> 16)];
      }
      x += kStretch * dx;
      y += kStretch * dy;
    }
  }
  to[0] = to[1] = sum;  // the second for the stretch that begins with the end of the row

  used_[direction].store(true, std::memory_order_relaxed);
  const std::uint32_t* other = nullptr;
  auto& slot = slots_[direction * rows_ + row];
  if (slot.compare_exchange_strong(other, sums, std::memory_order_acq_rel)) return sums;
  memory.giveBack(count);
  return other;
}

}  // namespace handmap
