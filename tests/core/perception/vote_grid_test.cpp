#include "core/perception/vote_grid.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "core/base/random.h"

namespace handmap {
namespace {

TEST(VoteGrid, SmoothsLikeAGaussianOfTheWholeGrid) {
  for (const double sigma : {0.0, 0.6, 2.0, 5.0}) {
    for (const int side : {5, 64, 203}) {
      VoteGrid grid(side, sigma);
      for (std::uint32_t frame = 0; frame < 3; ++frame) {
        cv::Mat1f expected(side, side, 0.0F);
        RandomStream random(3, frame);
        for (int i = 0; i < 40; ++i) {
          const int x = random.index(side);
          const int y = random.index(side);
          grid.add(x, y, 1.5F);
          expected(y, x) += 1.5F;
        }
        cv::min(expected, 2.0, expected);
        if (sigma > 0.0) {
          const int size = 2 * cvRound(4.0 * sigma) + 1;
          cv::GaussianBlur(expected, expected, {size, size}, sigma, sigma, cv::BORDER_CONSTANT);
        }
        expected *= 0.7;
        cv::min(expected, 1.0, expected);
        cv::Mat1f found(side, side, 0.0F);
        grid.moveTo(found, 2.0F, 0.7F);
        EXPECT_LT(cv::norm(found, expected, cv::NORM_INF), 1e-6) << sigma << ' ' << side;
        // The share of cells that are not 0 counts too.
        EXPECT_EQ(cv::countNonZero(found), cv::countNonZero(expected)) << sigma << ' ' << side;
      }
    }
  }
}

TEST(VoteGrid, DropsVotesBesideIt) {
  VoteGrid grid(40, 2.0);
  for (const std::int64_t place : {-1L, 40L, -1000000000000L, 1000000000000L}) {
    grid.add(place, 5, 1.0F);
    grid.add(5, place, 1.0F);
  }
  cv::Mat1f cells(40, 40, 0.0F);
  grid.moveTo(cells, 3.0F, 1.0F);
  EXPECT_EQ(cv::countNonZero(cells), 0);
}

}  // namespace
}  // namespace handmap
