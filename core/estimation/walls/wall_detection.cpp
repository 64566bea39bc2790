#include "core/estimation/walls/wall_detection.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"

namespace handmap {

namespace {

constexpr double kSameWall = 1.5;  // metres between walls that are one; choice: three cells

/// The running sum along one row.
struct Run {
  std::int32_t sum = 0;
  std::int32_t peak = 0;
  int begin = 0;
  int peak_at = 0;
};

/// Runs along the rows of one image, all rows side by side, the rows tilted by `tilt`.
class RowScan {
 public:
  RowScan(const WallImage& image, double tilt, const DetectionOptions& options,
          std::vector<FoundWall>& walls)
      : image_(image),
        slope_(std::tan(tilt)),
        least_score_(static_cast<std::int32_t>(options.least_score * WallImage::kScale)),
        least_length_(options.least_length_m / image.cell()),
        drop_(static_cast<std::int32_t>(options.drop * WallImage::kScale)),
        walls_(walls) {}

  void operator()(int column_low, int column_high, int row_low, int row_high) {
    runs_.assign(static_cast<std::size_t>(row_high - row_low), Run{});
    row_low_ = row_low;
    middle_ = (column_low + column_high) / 2;
    for (int column = column_low; column < column_high; ++column) {
      const std::int32_t* cells = image_.column(column);
      const int shift = row_low + shiftAt(column);
      const int mask = image_.size() - 1;
      for (std::size_t i = 0; i < runs_.size(); ++i) {
        const std::int32_t value = cells[(shift + static_cast<int>(i)) & mask];
        if (value != 0) advance(i, value, column);
      }
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) close(i);
  }

 private:
  int shiftAt(int column) const {
    return static_cast<int>(std::lround(slope_ * (column - middle_)));
  }

  void advance(std::size_t i, std::int32_t value, int column) {
    Run& run = runs_[i];
    if (run.sum == 0 && value < 0) return;
    if (run.sum == 0) run.begin = column;
    run.sum += value;
    if (run.sum > run.peak) {
      run.peak = run.sum;
      run.peak_at = column;
    } else if (run.sum <= 0 || run.sum < run.peak - drop_) {
      close(i);
    }
  }

  void close(std::size_t i) {
    const Run run = runs_[i];
    runs_[i] = Run{};
    if (run.peak < least_score_ || run.peak_at - run.begin < least_length_) return;
    walls_.push_back(
        {pointAt(run.begin, i), pointAt(run.peak_at + 1, i), run.peak / WallImage::kScale});
  }

  Vec2 pointAt(int column, std::size_t i) const {
    const double row = row_low_ + static_cast<double>(i) + 0.5 + slope_ * (column - middle_);
    return image_.cell() * (column * image_.along() + row * image_.across());
  }

  const WallImage& image_;
  double slope_;
  std::int32_t least_score_;
  double least_length_;
  std::int32_t drop_;
  std::vector<FoundWall>& walls_;
  std::vector<Run> runs_;
  int row_low_ = 0;
  int middle_ = 0;
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
  const std::size_t tilts = options.tilts.size();
  std::vector<std::vector<FoundWall>> found(images.size() * tilts);
  parallelFor(found.size(), [&](std::size_t i) {
    const WallImage& image = images[i / tilts];
    const auto at = [&](double metres) { return static_cast<int>(metres / image.cell()); };
    const double along = image.along().dot(middle);
    const double across = image.across().dot(middle);
    RowScan scan(image, options.tilts[i % tilts], options, found[i]);
    scan(at(along - reach_m), at(along + reach_m), at(across - reach_m), at(across + reach_m));
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
