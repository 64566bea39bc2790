#include "core/estimation/walls/wall_detection.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace handmap {

namespace {

constexpr double kSameWall = 1.5;  // metres between walls that are one; choice: three cells

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

/// What there is at most for a wall along any row, tilted by little: sums of what is positive over
/// blocks of columns, so short that a tilted row meets two neighbouring cells of each at most.
class WallBounds {
 public:
  /// Cells count up to `most`: enough for a wall by themselves.
  WallBounds(const WallImage& image, const Window& window, double most_slope, std::int32_t most)
      : window_(window),
        block_(most_slope > 0.0 ? std::max(1, static_cast<int>(0.99 / most_slope))
                                : window.column_high - window.column_low) {
    const int half = (window.column_high - window.column_low) / 2 + 1;
    margin_ = static_cast<int>(std::ceil(most_slope * half)) + 2;
    row_count_ = window.rows() + 2 * margin_;
    const int mask = image.size() - 1;
    for (int begin = window.column_low; begin < window.column_high; begin += block_) {
      std::vector<std::int32_t> sums(static_cast<std::size_t>(row_count_));
      for (int column = begin; column < endOf(begin); ++column) {
        const std::int32_t* cells = image.column(column);
        const int first = window.row_low - margin_;
        for (int i = 0; i < row_count_;) {  // up to where the image is wrapped around
          const int row = (first + i) & mask;
          const int count = std::min(row_count_ - i, image.size() - row);
          for (int k = 0; k < count; ++k) {
            sums[static_cast<std::size_t>(i + k)] += std::clamp(cells[row + k], 0, most);
          }
          i += count;
        }
      }
      for (std::size_t i = 0; i + 1 < sums.size(); ++i) sums[i] += sums[i + 1];
      blocks_.push_back(std::move(sums));
    }
  }

  /// The rows that may hold so much, counted from the first of the window.
  std::vector<int> rowsWith(std::int32_t least, const Tilt& tilt) const {
    std::vector<std::int32_t> bounds(static_cast<std::size_t>(window_.rows()));
    int begin = window_.column_low;
    for (const std::vector<std::int32_t>& sums : blocks_) {
      const int shift = std::min(tilt.shiftAt(begin), tilt.shiftAt(endOf(begin) - 1));
      const std::int32_t* first = sums.data() + margin_ + shift;
      for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] += first[i];
      begin += block_;
    }
    std::vector<int> rows;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (bounds[i] >= least) rows.push_back(static_cast<int>(i));
    }
    return rows;
  }

 private:
  int endOf(int begin) const { return std::min(begin + block_, window_.column_high); }

  Window window_;
  int block_;   ///< columns
  int margin_;  ///< rows beyond the window that tilted ones reach
  int row_count_;
  std::vector<std::vector<std::int32_t>> blocks_;  ///< of a row and the next
};

/// The running sum along one row.
struct Run {
  int row = 0;  ///< from the first of the window
  std::int32_t sum = 0;
  std::int32_t peak = 0;
  int begin = 0;
  int peak_at = 0;
};

/// Runs along tilted rows of one image, side by side.
class RowScan {
 public:
  RowScan(const WallImage& image, const Window& window, const Tilt& tilt,
          const DetectionOptions& options, std::vector<FoundWall>& walls)
      : image_(image),
        window_(window),
        tilt_(tilt),
        least_score_(leastScore(options)),
        least_length_(options.least_length_m / image.cell()),
        drop_(static_cast<std::int32_t>(options.drop * WallImage::kScale)),
        walls_(walls) {}

  static std::int32_t leastScore(const DetectionOptions& options) {
    return static_cast<std::int32_t>(options.least_score * WallImage::kScale);
  }

  void operator()(const std::vector<int>& rows) {
    runs_.clear();
    for (const int row : rows) runs_.push_back({row});
    const int mask = image_.size() - 1;
    for (int column = window_.column_low; column < window_.column_high; ++column) {
      const std::int32_t* cells = image_.column(column);
      const int shift = window_.row_low + tilt_.shiftAt(column);
      for (Run& run : runs_) {
        const std::int32_t value = cells[(shift + run.row) & mask];
        if (value != 0) advance(run, value, column);
      }
    }
    for (Run& run : runs_) close(run);
  }

 private:
  void advance(Run& run, std::int32_t value, int column) {
    if (run.sum == 0 && value < 0) return;
    if (run.sum == 0) run.begin = column;
    run.sum += value;
    if (run.sum > run.peak) {
      run.peak = run.sum;
      run.peak_at = column;
    } else if (run.sum <= 0 || run.sum < run.peak - drop_) {
      close(run);
    }
  }

  void close(Run& run) {
    const Run done = run;
    run = {done.row};
    if (done.peak < least_score_ || done.peak_at - done.begin < least_length_) return;
    walls_.push_back({pointAt(done.begin, done.row), pointAt(done.peak_at + 1, done.row),
                      done.peak / WallImage::kScale});
  }

  Vec2 pointAt(int column, int i) const {
    const double row =
        window_.row_low + static_cast<double>(i) + 0.5 + tilt_.slope * (column - tilt_.middle);
    return image_.cell() * (column * image_.along() + row * image_.across());
  }

  const WallImage& image_;
  Window window_;
  Tilt tilt_;
  std::int32_t least_score_;
  double least_length_;
  std::int32_t drop_;
  std::vector<FoundWall>& walls_;
  std::vector<Run> runs_;
};

bool same(const FoundWall& wall, const FoundWall& surer) {
  const Vec2 along = (surer.b - surer.a).normalized();
  if (along.dot(wall.b - wall.a) < 0.7 * wall.length()) return false;
  const double begin = along.dot(wall.a - surer.a);
  const double end = along.dot(wall.b - surer.a);
  const double common = std::min(end, surer.length()) - std::max(begin, 0.0);
  if (common < 0.3 * std::min(wall.length(), surer.length())) return false;
  const double at = (std::max(begin, 0.0) + std::min(end, surer.length())) / 2.0;
  const double share = (at - begin) / (end - begin);
  const Vec2 there = wall.a + share * (wall.b - wall.a);
  return std::abs(cross(along, there - surer.a)) < kSameWall;
}

}  // namespace

std::vector<FoundWall> detectWalls(const WallEvidence& evidence, const Vec2& middle, double reach_m,
                                   const DetectionOptions& options) {
  const std::vector<WallImage>& images = evidence.images();
  double most_slope = 0.0;
  for (const double tilt : options.tilts) {
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
    const std::int32_t least = RowScan::leastScore(options);
    const WallBounds bounds(image, window, most_slope, least);
    for (const double angle : options.tilts) {
      const Tilt tilt{std::tan(angle), window.middle()};
      RowScan(image, window, tilt, options, found[i])(bounds.rowsWith(least, tilt));
    }
  });
  std::vector<FoundWall> walls;
  for (const auto& some : found) walls.insert(walls.end(), some.begin(), some.end());
  std::stable_sort(walls.begin(), walls.end(),
                   [](const FoundWall& a, const FoundWall& b) { return a.score > b.score; });
  std::vector<FoundWall> kept;
  for (const FoundWall& wall : walls) {
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const FoundWall& surer) { return same(wall, surer); })) {
      kept.push_back(wall);
    }
  }
  return kept;
}

}  // namespace handmap
