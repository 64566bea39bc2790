#include "core/estimation/walls/wall_detection.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/base/parallel.h"
#include "core/estimation/walls/constants.h"

namespace handmap {

using namespace walls;

namespace {

/// As cells have them.
constexpr std::int32_t inCells(double nats) { return static_cast<std::int32_t>(nats * kScale); }

/// The part of an image that is looked at.
struct Window {
  int column_low;
  int column_high;
  int row_low;
  int row_high;
  int middle() const { return (column_low + column_high) / 2; }
  int rows() const { return row_high - row_low; }
};

/// Rows of an image that are tilted about the middle of the window.
struct Tilt {
  double slope;
  int middle;
  int shiftAt(int column) const { return static_cast<int>(std::lround(slope * (column - middle))); }
};

/// What a wall along a row, tilted by little, has at most: of blocks of columns, so short that a
/// tilted row meets two neighbouring cells of each column at most, and the larger counts.
class WallBounds {
 public:
  WallBounds(const WallImage& image, const Window& window, double most_slope)
      : window_(window),
        block_(most_slope > 0.0 ? std::max(1, static_cast<int>(0.99 / most_slope))
                                : window.column_high - window.column_low) {
    const int half = (window.column_high - window.column_low) / 2 + 1;
    margin_ = static_cast<int>(std::ceil(most_slope * half)) + 2;
    const auto rows = static_cast<std::size_t>(window.rows() + 2 * margin_);
    std::vector<std::int32_t> wrapped(rows + 1);
    for (int begin = window.column_low; begin < window.column_high; begin += block_) {
      Block block{std::vector<std::int32_t>(rows), std::vector<std::int32_t>(rows)};
      for (int column = begin; column < endOf(begin); ++column) {
        const std::int32_t* cells = image.cells(column, window.row_low - margin_, wrapped);
        for (std::size_t i = 0; i < rows; ++i) {
          const std::int32_t larger = std::max(cells[i], cells[i + 1]);
          block.whole[i] += larger;
          block.part[i] += std::max(larger, 0);
        }
      }
      blocks_.push_back(std::move(block));
    }
  }

  /// The rows that may hold so much, counted from the first of the window.
  std::vector<int> rowsWith(std::int32_t least, const Tilt& tilt) const {
    const auto count = static_cast<std::size_t>(window_.rows());
    std::vector<std::int32_t> open(count);  // of walls that go on from block to block
    std::vector<std::int32_t> most(count);
    int begin = window_.column_low;
    for (const Block& block : blocks_) {
      const int shift = margin_ + std::min(tilt.shiftAt(begin), tilt.shiftAt(endOf(begin) - 1));
      const std::int32_t* part = block.part.data() + shift;
      const std::int32_t* whole = block.whole.data() + shift;
      for (std::size_t i = 0; i < count; ++i) {
        most[i] = std::max(most[i], open[i] + part[i]);
        open[i] = std::max(open[i] + whole[i], part[i]);
      }
      begin += block_;
    }
    std::vector<int> rows;
    for (std::size_t i = 0; i < count; ++i) {
      if (most[i] >= least) rows.push_back(static_cast<int>(i));
    }
    return rows;
  }

 private:
  struct Block {
    std::vector<std::int32_t> whole;  ///< of a wall that goes through it, by row
    std::vector<std::int32_t> part;   ///< of one that begins or ends in it
  };
  int endOf(int begin) const { return std::min(begin + block_, window_.column_high); }

  Window window_;
  int block_;   ///< columns
  int margin_;  ///< rows beyond the window that tilted ones reach
  std::vector<Block> blocks_;
};

/// Numbers of neighbouring rows, worked on at once; comparisons give −1 or 0.
using Lanes [[gnu::vector_size(kLanes * sizeof(std::int32_t))]] = std::int32_t;

Lanes load(const std::int32_t* cells) {
  Lanes lanes;
  std::memcpy(&lanes, cells, sizeof(lanes));
  return lanes;
}

bool any(const Lanes& mask) {
  const auto parts = std::bit_cast<std::array<std::uint64_t, kLanes / 2>>(mask);
  return (parts[0] | parts[1]) != 0;
}

/// The running sums along neighbouring rows.
struct Runs {
  int row = 0;  ///< the first, from the first of the window
  Lanes sum{};
  Lanes peak{};
  Lanes begin{};
  Lanes peak_at{};
  Lanes closed{};  ///< peaks of the runs that the last column has closed, else 0

  void advance(const Lanes& cells, int column, std::int32_t drop) {
    begin = sum == 0 ? Lanes{} + column : begin;
    sum += cells;
    peak_at = sum > peak ? Lanes{} + column : peak_at;
    peak = sum > peak ? sum : peak;
    const Lanes ends = (sum <= 0) | (sum < peak - drop);
    closed = peak & ends;
    sum &= ~ends;
    peak &= ~ends;
  }
};

/// Runs along tilted rows of one image.
class RowScan {
 public:
  RowScan(const WallImage& image, const Window& window, const Tilt& tilt,
          std::vector<FoundWall>& walls)
      : image_(image),
        window_(window),
        tilt_(tilt),
        least_length_(kLeastWall_m / image.cell()),
        walls_(walls) {}

  /// Ascending rows.
  void operator()(const std::vector<int>& rows) {
    runs_.clear();
    for (const int row : rows) {
      if (runs_.empty() || row >= runs_.back().row + static_cast<int>(kLanes))
        runs_.push_back({row});
    }
    std::array<std::int32_t, kLanes> wrapped;
    for (int column = window_.column_low; column < window_.column_high; ++column) {
      const int shift = window_.row_low + tilt_.shiftAt(column);
      for (Runs& runs : runs_) {
        runs.advance(load(image_.cells(column, shift + runs.row, wrapped)), column, inCells(kDrop));
        close(runs, runs.closed);
      }
    }
    for (const Runs& runs : runs_) close(runs, runs.peak);
  }

 private:
  void close(const Runs& runs, const Lanes& peaks) {
    if (!any(peaks >= inCells(kLeastScore))) return;
    const int count = std::min(static_cast<int>(kLanes), window_.rows() - runs.row);
    for (int i = 0; i < count; ++i) {
      const int begin = runs.begin[i];
      const int last = runs.peak_at[i];
      if (peaks[i] < inCells(kLeastScore) || last - begin < least_length_) continue;
      walls_.push_back(
          {pointAt(begin, runs.row + i), pointAt(last + 1, runs.row + i), peaks[i] / kScale});
    }
  }

  Vec2 pointAt(int column, int i) const {
    const double row =
        window_.row_low + static_cast<double>(i) + 0.5 + tilt_.slope * (column - tilt_.middle);
    return image_.cell() * (column * image_.along() + row * image_.across());
  }

  const WallImage& image_;
  Window window_;
  Tilt tilt_;
  double least_length_;
  std::vector<FoundWall>& walls_;
  std::vector<Runs> runs_;
};

/// A wall that is kept: what others are compared with.
class KeptWall {
 public:
  explicit KeptWall(const FoundWall& wall)
      : a_(wall.a), along_((wall.b - wall.a).normalized()), length_(wall.length()) {}

  bool isSame(const FoundWall& wall, double length) const {
    if (along_.dot(wall.b - wall.a) < kSameHeading * length) return false;
    const double begin = along_.dot(wall.a - a_);
    const double end = along_.dot(wall.b - a_);
    const double common = std::min(end, length_) - std::max(begin, 0.0);
    if (common < kCommon * std::min(length, length_)) return false;
    const double at = (std::max(begin, 0.0) + std::min(end, length_)) / 2.0;
    const double share = (at - begin) / (end - begin);
    const Vec2 there = wall.a + share * (wall.b - wall.a);
    return std::abs(cross(along_, there - a_)) < kSameWall_m;
  }

 private:
  Vec2 a_;
  Vec2 along_;
  double length_;
};

/// Of walls that lie on one another the surest, which comes first.
std::vector<FoundWall> withoutRepeats(const std::vector<FoundWall>& walls) {
  std::vector<FoundWall> single;
  std::vector<KeptWall> kept;
  for (const FoundWall& wall : walls) {
    const double length = wall.length();
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const KeptWall& surer) { return surer.isSame(wall, length); })) {
      single.push_back(wall);
      kept.emplace_back(wall);
    }
  }
  return single;
}

}  // namespace

std::vector<FoundWall> detectWalls(const WallEvidence& evidence, const Vec2& middle, double reach_m,
                                   std::span<const double> tilts) {
  const std::vector<WallImage>& images = evidence.images();
  double most_slope = 0.0;
  for (const double tilt : tilts) {
    most_slope = std::max(most_slope, std::abs(std::tan(tilt)));
  }
  std::vector<std::vector<FoundWall>> found(images.size());
  parallelFor(images.size(), [&](std::size_t i) {
    const WallImage& image = images[i];
    const auto at = [&](double metres) { return static_cast<int>(metres / image.cell()); };
    const double along = image.along().dot(middle);
    const double across = image.across().dot(middle);
    const Window window{at(along - reach_m), at(along + reach_m), at(across - reach_m),
                        at(across + reach_m)};
    const WallBounds bounds(image, window, most_slope);
    for (const double angle : tilts) {
      const Tilt tilt{std::tan(angle), window.middle()};
      RowScan(image, window, tilt, found[i])(bounds.rowsWith(inCells(kLeastScore), tilt));
    }
  });
  std::vector<FoundWall> walls;
  for (const auto& some : found) walls.insert(walls.end(), some.begin(), some.end());
  std::stable_sort(walls.begin(), walls.end(),
                   [](const FoundWall& a, const FoundWall& b) { return a.score > b.score; });
  return withoutRepeats(walls);
}

}  // namespace handmap
