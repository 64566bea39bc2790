// A square grid that votes are cast into and that is then smoothed. It costs what the votes cover,
// not what the grid does.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/perception/constants.h"

namespace handmap {

class VoteGrid {
 public:
  /// `sigma_cells` of the Gaussian, cut off at four of it; 0: not smoothed.
  VoteGrid(int side, double sigma_cells);

  /// Votes beside the grid are dropped.
  void add(std::int64_t column, std::int64_t row, float weight) {
    const auto x = static_cast<std::uint64_t>(column);
    const auto y = static_cast<std::uint64_t>(row);
    if (x >= side_ || y >= side_) return;
    votes_[(y + pad_) * stride_ + x + pad_] += weight;
    voted_[(y + pad_) / perception::kBlock * blocks_ + (x + pad_) / perception::kBlock] = 1;
  }

  /// Votes, at most `saturation` a cell, smoothed, times `scale` and at most 1, into `cells`, which
  /// is side × side and zero. Takes all votes out again.
  void moveTo(cv::Mat1f& cells, float saturation, float scale);

 private:
  using Flags = std::vector<std::uint8_t>;  ///< by block, row by row
  /// The blocks that a flagged one is smoothed into, along rows (step 1) or columns (`blocks_`).
  Flags spread(const Flags& flags, std::size_t step) const;
  template <typename Function>
  void forEachBlock(const Flags& flags, const Function& function) const;
  void saturate(float saturation);
  void clear(std::vector<float>& values, const Flags& flags) const;

  std::size_t side_;
  std::size_t pad_;     ///< cells around the grid, so that smoothing needs no check
  std::size_t blocks_;  ///< in a row
  std::size_t stride_;
  std::vector<float> kernel_;
  std::vector<float> votes_;
  std::vector<float> smoothed_;  ///< along rows
  Flags voted_;
};

}  // namespace handmap
