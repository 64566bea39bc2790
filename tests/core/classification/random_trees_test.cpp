#include "core/classification/random_trees.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/random.h"

namespace handmap {
namespace {

struct Board {
  SampleMatrix samples;
  std::vector<bool> positive;
};

/// Four fields of a chess board, which no line can part, beside a feature without meaning.
Board makeBoard(int count, double share_positive, std::uint64_t seed) {
  RandomStream random(seed);
  Board board{SampleMatrix(count, 3), {}};
  for (int i = 0; i < count; ++i) {
    const bool positive = random.uniform() < share_positive;
    const double x = random.uniform(-1.0, 1.0);
    const double y = std::copysign(random.uniform(), positive ? x : -x);
    board.samples.row(i) << static_cast<float>(x), static_cast<float>(y),
        static_cast<float>(random.uniform());
    board.positive.push_back(positive);
  }
  return board;
}

/// Of the positive ones or of the others.
double shareJudgedPositive(const RandomTrees& trees, const Board& board, bool positive) {
  const Eigen::VectorXf votes = trees.decide(board.samples);
  int all = 0;
  int judged = 0;
  for (Eigen::Index i = 0; i < votes.size(); ++i) {
    if (board.positive[static_cast<std::size_t>(i)] != positive) continue;
    ++all;
    judged += votes[i] > 0.0F ? 1 : 0;
  }
  return static_cast<double>(judged) / all;
}

TEST(RandomTrees, PartTheFieldsOfAChessBoard) {
  const Board board = makeBoard(2000, 0.5, 1);
  const RandomTrees trees = RandomTrees::train(board.samples, board.positive, {});
  const Board unseen = makeBoard(1000, 0.5, 2);
  EXPECT_GT(shareJudgedPositive(trees, unseen, true), 0.93);
  EXPECT_LT(shareJudgedPositive(trees, unseen, false), 0.07);
  EXPECT_LE(trees.decide(unseen.samples).cwiseAbs().maxCoeff(), 1.0F);
}

TEST(RandomTrees, AreNotSwayedByRareClasses) {
  const Board board = makeBoard(4000, 0.1, 3);
  const RandomTrees trees = RandomTrees::train(board.samples, board.positive, {});
  const Board unseen = makeBoard(1000, 0.5, 4);
  EXPECT_GT(shareJudgedPositive(trees, unseen, true), 0.9);
  EXPECT_LT(shareJudgedPositive(trees, unseen, false), 0.1);
}

TEST(RandomTrees, DependOnTheSeedAlone) {
  const Board board = makeBoard(300, 0.5, 5);
  const auto votes = [&](std::uint64_t seed) {
    return RandomTrees::train(board.samples, board.positive, {.trees = 3, .seed = seed})
        .decide(board.samples);
  };
  EXPECT_EQ(votes(1), votes(1));
  EXPECT_NE(votes(1), votes(2));
}

TEST(RandomTrees, AreLeavesWhereNothingTellsTheClassesApart) {
  const SampleMatrix same = SampleMatrix::Constant(100, 2, 1.0F);
  std::vector<bool> positive(100, false);
  std::fill_n(positive.begin(), 30, true);
  const RandomTrees trees = RandomTrees::train(same, positive, {.trees = 2});
  EXPECT_EQ(trees.trees()[0].size(), 1U);
  EXPECT_NEAR(trees.decide(same).cwiseAbs().maxCoeff(), 0.0, 1e-4);
}

}  // namespace
}  // namespace handmap
