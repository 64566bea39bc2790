#include "core/perception/vote_grid.h"

#include <algorithm>

#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

#include "core/perception/constants.h"

namespace handmap {

using namespace perception;

namespace {

using Run = Eigen::Array<float, 16, 1>;

/// `values` and the next 15 cells of the row, smoothed over the cells that lie `step` apart.
Run convolved(const float* values, std::ptrdiff_t step, const std::vector<float>& kernel) {
  const float* from = values - step * static_cast<std::ptrdiff_t>(kernel.size() / 2);
  Run result = Run::Zero();
  for (const float weight : kernel) {
    result += weight * Eigen::Map<const Run>(from);
    from += step;
  }
  return result;
}

std::size_t roundedUp(std::size_t value, std::size_t unit) {
  return (value + unit - 1) / unit * unit;
}

}  // namespace

VoteGrid::VoteGrid(int side, double sigma_cells) : side_(static_cast<std::size_t>(side)) {
  const int radius = cvRound(4.0 * sigma_cells);
  kernel_ = radius > 0 ? cv::getGaussianKernel(2 * radius + 1, sigma_cells, CV_32F)
                       : cv::Mat1f::ones(1, 1);
  pad_ = roundedUp(static_cast<std::size_t>(radius), kBlock);
  stride_ = roundedUp(side_, kBlock) + 2 * pad_;
  blocks_ = stride_ / kBlock;
  votes_.resize(stride_ * stride_);
  smoothed_.resize(stride_ * stride_);
  voted_.resize(blocks_ * blocks_);
}

template <typename Function>
void VoteGrid::forEachBlock(const Flags& flags, const Function& function) const {
  for (std::size_t y = 0; y < blocks_; ++y) {
    for (std::size_t x = 0; x < blocks_; ++x) {
      if (flags[y * blocks_ + x] != 0) function(x * kBlock, y * kBlock);
    }
  }
}

VoteGrid::Flags VoteGrid::spread(const Flags& flags, std::size_t step) const {
  const std::size_t margin = pad_ / kBlock;
  Flags result = flags;
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == 0) continue;
    // No vote lies in the margin.
    for (std::size_t j = i - margin * step; j <= i + margin * step; j += step) result[j] = 1;
  }
  return result;
}

void VoteGrid::saturate(float saturation) {
  forEachBlock(voted_, [&](std::size_t x, std::size_t y) {
    for (std::size_t row = y; row < y + kBlock; ++row) {
      float* values = votes_.data() + row * stride_ + x;
      for (std::size_t i = 0; i < kBlock; ++i) values[i] = std::min(values[i], saturation);
    }
  });
}

void VoteGrid::clear(std::vector<float>& values, const Flags& flags) const {
  forEachBlock(flags, [&](std::size_t x, std::size_t y) {
    for (std::size_t row = y; row < y + kBlock; ++row) {
      std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(row * stride_ + x), kBlock, 0.0F);
    }
  });
}

void VoteGrid::moveTo(cv::Mat1f& cells, float saturation, float scale) {
  saturate(saturation);
  const Flags along_rows = spread(voted_, 1);
  forEachBlock(along_rows, [&](std::size_t x, std::size_t y) {
    for (std::size_t row = y; row < y + kBlock; ++row) {
      const std::size_t at = row * stride_ + x;
      Eigen::Map<Run>(smoothed_.data() + at) = convolved(votes_.data() + at, 1, kernel_);
    }
  });
  forEachBlock(spread(along_rows, blocks_), [&](std::size_t x, std::size_t y) {
    if (x < pad_ || x >= side_ + pad_) return;
    const int width = static_cast<int>(std::min(kBlock, side_ + pad_ - x));
    for (std::size_t row = std::max(y, pad_); row < std::min(y + kBlock, side_ + pad_); ++row) {
      const Run run = convolved(smoothed_.data() + row * stride_ + x,
                                static_cast<std::ptrdiff_t>(stride_), kernel_);
      float* to = cells.ptr<float>(static_cast<int>(row - pad_)) + (x - pad_);
      for (int i = 0; i < width; ++i) to[i] = std::min(scale * run[i], 1.0F);
    }
  });
  clear(votes_, voted_);
  clear(smoothed_, along_rows);
  std::fill(voted_.begin(), voted_.end(), std::uint8_t{0});
}

}  // namespace handmap
