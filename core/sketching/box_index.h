// Which of many boxes touch a box: a grid of cells, each with the boxes that reach into it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/polygon.h"

namespace handmap {

class BoxIndex {
 public:
  BoxIndex() = default;
  explicit BoxIndex(std::vector<Bounds> boxes);

  std::size_t size() const { return boxes_.size(); }
  const Bounds& box(std::size_t i) const { return boxes_[i]; }
  /// Another box in place of that one. Every search looks at each that was set: after many, make
  /// the index anew.
  void set(std::size_t i, const Bounds& box);
  std::size_t loosened() const { return loosened_; }  ///< how many were set
  /// Of boxes that share a point with `area`, their borders included; in rising order.
  std::vector<std::size_t> touching(const Bounds& area) const;

 private:
  struct Cells {
    std::int64_t left, right, bottom, top;
    std::int64_t count() const { return (right - left + 1) * (top - bottom + 1); }
  };
  Cells cellsOf(const Bounds& area) const;

  std::vector<Bounds> boxes_;
  Vec2 low_ = Vec2::Zero();
  Vec2 cell_ = Vec2::Ones();  ///< metres
  std::int64_t columns_ = 0;
  std::int64_t rows_ = 0;
  std::vector<std::uint32_t> starts_;  ///< of each cell's part of items_
  std::vector<std::uint32_t> items_;
  std::vector<std::uint32_t> loose_;  ///< boxes over many cells, and those that were set
  std::size_t loosened_ = 0;
};

}  // namespace handmap
