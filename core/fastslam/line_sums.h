// Sums of the local map along straight lines: a wall of any length costs two reads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/fastslam/row_memory.h"
#include "core/perception/local_map.h"

namespace handmap {

/// A direction of lines in the robot frame, to a quarter of a degree. Lines are not oriented: the
/// opposite direction is the same lines with the other sign.
struct LineDirection {
  static constexpr int kHalfTurn = 720;
  static constexpr double kStep = kPi / kHalfTurn;  ///< radians

  /// The nearest to a heading, in steps of kStep.
  static int stepsOf(double heading_rad) {
    return static_cast<int>(std::lround(heading_rad / kStep));
  }
  /// `steps` from ahead, less than a million to either side.
  explicit LineDirection(int steps) {
    const int turned = (steps + kManyTurns) % (2 * kHalfTurn);
    index = turned % kHalfTurn;
    sign = turned < kHalfTurn ? 1.0F : -1.0F;
  }
  int index;
  float sign;

 private:
  static constexpr int kManyTurns = 2 * kHalfTurn * 1000;
};

/// The cells of the local map under the visible walls of one building or of several.
struct WallCells {
  float sum = 0.0F;  ///< of the cell values
  float non_zero = 0.0F;
  int all = 0;
};

/// The local map read along rows that are turned in steps of a quarter of a degree, one cell wide
/// and in steps of one cell, nearest cell. Sums are kept for every fourth step: in between, cells
/// count as if the four were alike. A row is read when it is first asked for, by whichever thread
/// asks; what it holds does not depend on that.
class LineSums {
 public:
  /// Takes over a local map and forgets the one before. Values are rounded to unit(), those above
  /// 1 taken as 1. No other thread may read meanwhile.
  void reset(const LocalMap& local_map);

  double cell() const { return cell_; }
  /// 1/5000 for a map of 800 cells a side; two sums share 32 bits.
  float unit() const { return unit_; }

  Vec2 unitAlong(LineDirection direction) const {
    return static_cast<double>(direction.sign) * units_[static_cast<std::size_t>(direction.index)];
  }

  /// Adds the part within range of a line in `direction`: `lateral` to the left of the robot, from
  /// `from` to `to` along it, all in cells.
  void add(LineDirection direction, float lateral, float from, float to, WallCells& cells) const {
    const float place = direction.sign * lateral + static_cast<float>(radius_);
    if (!(place >= 0.0F && place < static_cast<float>(2 * radius_))) return;
    const auto row = static_cast<std::size_t>(place);
    const auto half = static_cast<float>(half_[row]);
    const float ends[] = {direction.sign * from, direction.sign * to};
    const int first = indexOf(std::min(ends[0], ends[1]), half);
    const int last = indexOf(std::max(ends[0], ends[1]), half);
    if (first >= last) return;
    const std::uint32_t* sums = rowOf(static_cast<std::size_t>(direction.index), row);
    const std::uint32_t* low = sums + first / kStretch;
    const std::uint32_t* high = sums + last / kStretch;
    const std::uint32_t whole = high[0] - low[0];
    const std::uint32_t more = (high[1] - high[0]) * static_cast<std::uint32_t>(last % kStretch);
    const std::uint32_t less = (low[1] - low[0]) * static_cast<std::uint32_t>(first % kStretch);
    const auto parts = [&](const auto& field) {
      return static_cast<float>(
          static_cast<std::int32_t>(kStretch * field(whole) + field(more) - field(less)));
    };
    cells.sum += unit_ / kStretch * parts([&](std::uint32_t entry) { return entry & sum_mask_; });
    cells.non_zero +=
        1.0F / kStretch * parts([&](std::uint32_t entry) { return entry >> sum_bits_; });
    cells.all += last - first;
  }

 private:
  static std::vector<Vec2> unitVectors();
  static int indexOf(float along, float half) {
    constexpr float kHalf = 0.5F;  // nothing is negative here: this rounds
    return static_cast<int>(std::min(half, std::max(-half, along)) + half + kHalf);
  }
  const std::uint32_t* rowOf(std::size_t direction, std::size_t row) const {
    const std::size_t slot = direction * rows_ + row;
    const std::uint32_t* sums = slots_[slot].load(std::memory_order_acquire);
    return sums != nullptr ? sums : read(direction, row);
  }
  const std::uint32_t* read(std::size_t direction, std::size_t row) const;
  void resize(const LocalMap& local_map);
  void takeBlocks(const cv::Mat1f& cells, int row);

  static constexpr int kBlockBits = 3;
  static constexpr int kBlock = 1 << kBlockBits;  ///< cells, either way
  static constexpr int kStretch = 4;              ///< cells between two sums of a row

  std::vector<Vec2> units_ = unitVectors();  ///< along rows, by direction
  double cell_ = 0.0;
  int radius_ = 0;              ///< cells
  std::size_t rows_ = 0;        ///< of one direction
  std::vector<int> half_;       ///< cells of a row to either side, by row
  std::int32_t origin_ = 0;     ///< column and row of the robot, 16 bits of fraction
  std::uint32_t sum_bits_ = 0;  ///< the low bits of an entry hold the sum, the others the number
  std::uint32_t sum_mask_ = 0;
  float unit_ = 0.0F;
  int stride_ = 0;                     ///< cells in a row of the local map
  std::vector<std::uint32_t> packed_;  ///< its cells, as entries of one cell
  int blocks_ = 0;                     ///< in a row of the local map
  cv::Mat1b hit_;                      ///< by block, one more around: whether any cell is not 0
  cv::Mat1b near_hit_;                 ///< the same of a block and those around it
  // By direction and row; null: not yet read.
  mutable std::unique_ptr<std::atomic<const std::uint32_t*>[]> slots_;
  mutable std::vector<std::atomic<bool>> used_ =
      std::vector<std::atomic<bool>>(LineDirection::kHalfTurn);
  mutable PerThread<RowMemory> memory_;
};

}  // namespace handmap
