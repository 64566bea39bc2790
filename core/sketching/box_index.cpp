#include "core/sketching/box_index.h"

#include <algorithm>
#include <cmath>

namespace handmap {

namespace {

constexpr std::int64_t kManyCells = 16;
constexpr double kBoxesPerCell = 2.0;

bool touch(const Bounds& a, const Bounds& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

BoxIndex::BoxIndex(std::vector<Bounds> boxes) : boxes_(std::move(boxes)) {
  if (boxes_.empty()) return;
  Bounds all = boxes_.front();
  for (const Bounds& box : boxes_) {
    all.low = all.low.cwiseMin(box.low);
    all.high = all.high.cwiseMax(box.high);
  }
  const double side = std::ceil(std::sqrt(static_cast<double>(boxes_.size()) / kBoxesPerCell));
  low_ = all.low;
  columns_ = rows_ = static_cast<std::int64_t>(side);
  cell_ = ((all.high - all.low) / side).cwiseMax(1e-6);

  starts_.assign(static_cast<std::size_t>(columns_ * rows_ + 1), 0);
  const auto for_cells = [&](std::size_t i, auto visit) {
    const Cells cells = cellsOf(boxes_[i]);
    if (cells.count() > kManyCells) return false;
    for (std::int64_t row = cells.bottom; row <= cells.top; ++row)
      for (std::int64_t column = cells.left; column <= cells.right; ++column)
        visit(static_cast<std::size_t>(row * columns_ + column));
    return true;
  };
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!for_cells(i, [&](std::size_t cell) { ++starts_[cell + 1]; }))
      loose_.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t cell = 1; cell < starts_.size(); ++cell) starts_[cell] += starts_[cell - 1];
  items_.resize(starts_.back());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::size_t i = 0; i < boxes_.size(); ++i)
    for_cells(i, [&](std::size_t cell) { items_[next[cell]++] = static_cast<std::uint32_t>(i); });
}

/// The cells still name it where it was: whoever looks there looks at the box itself.
void BoxIndex::set(std::size_t i, const Bounds& box) {
  boxes_[i] = box;
  const auto number = static_cast<std::uint32_t>(i);
  if (std::ranges::find(loose_, number) != loose_.end()) return;
  loose_.push_back(number);
  ++loosened_;
}

BoxIndex::Cells BoxIndex::cellsOf(const Bounds& area) const {
  const auto cell = [](double offset, double size, std::int64_t count) {
    return static_cast<std::int64_t>(
        std::clamp(std::floor(offset / size), 0.0, static_cast<double>(count - 1)));
  };
  const Vec2 low = area.low - low_;
  const Vec2 high = area.high - low_;
  return {cell(low.x(), cell_.x(), columns_), cell(high.x(), cell_.x(), columns_),
          cell(low.y(), cell_.y(), rows_), cell(high.y(), cell_.y(), rows_)};
}

std::vector<std::size_t> BoxIndex::touching(const Bounds& area) const {
  std::vector<std::size_t> found;
  if (boxes_.empty()) return found;
  const auto take = [&](std::uint32_t i) {
    if (touch(boxes_[i], area)) found.push_back(i);
  };
  const Cells cells = cellsOf(area);
  for (std::int64_t row = cells.bottom; row <= cells.top; ++row) {
    const auto first = static_cast<std::size_t>(row * columns_ + cells.left);
    const auto last = static_cast<std::size_t>(row * columns_ + cells.right);
    for (std::uint32_t at = starts_[first]; at < starts_[last + 1]; ++at) take(items_[at]);
  }
  for (const std::uint32_t i : loose_) take(i);
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace handmap
