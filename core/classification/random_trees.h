// Extremely randomized trees (Geurts, Ernst and Wehenkel, "Extremely randomized trees", 2006).
//
// Taught with real streets they are better in others than the support vector machine; taught with
// rendered ones they are worse in real ones (README.md has the figures).
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/classification/sample_matrix.h"

namespace handmap {

struct TreeOptions {
  int trees = 40;
  int least = 10;  ///< samples of a leaf
  std::uint64_t seed = 1;
};

/// A branch asks whether a feature is below a value; the next node is where it goes then.
struct TreeNode {
  static constexpr int kLeaf = -1;
  int feature = kLeaf;
  float value = 0.0F;  ///< of a branch the border, of a leaf the vote from −1 to 1 (positive)
  int right = 0;       ///< of a branch: the node where to go else, behind its next one
};

using DecisionTree = std::vector<TreeNode>;  ///< from its root

class RandomTrees {
 public:
  /// At least one; none is empty, branches go to later nodes that are there.
  explicit RandomTrees(std::vector<DecisionTree> trees) : trees_(std::move(trees)) {}

  /// `positive[i]` is the class of row i; both are there. The classes weigh the same whatever their
  /// sizes.
  static RandomTrees train(const SampleMatrix& samples, const std::vector<bool>& positive,
                           const TreeOptions& options);

  /// Of every row the mean vote, from −1 to 1; > 0 is the positive class.
  Eigen::VectorXf decide(const SampleMatrix& samples) const;

  const std::vector<DecisionTree>& trees() const { return trees_; }

 private:
  std::vector<DecisionTree> trees_;
};

}  // namespace handmap
