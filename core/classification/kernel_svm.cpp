#include "core/classification/kernel_svm.h"

#include <algorithm>
#include <utility>

#include <Eigen/Cholesky>

#include "core/classification/clusters.h"

namespace handmap {

namespace {

constexpr int kMaxIterations = 30;
constexpr Eigen::Index kBlock = 128;  // samples at a time: their kernels stay in the cache
constexpr double kRidge = 0.01;       // of the norm: vectors that lie close together

/// What training minimizes: penalty over the weights, costs of the samples inside the margin.
struct Problem {
  Eigen::MatrixXd inputs;   ///< samples × weights
  Eigen::VectorXd targets;  ///< ±1
  Eigen::VectorXd costs;
  Eigen::MatrixXd penalty;
};

/// Newton's method: each step is a weighted least squares over the samples inside the margin, until
/// those stay the same.
Eigen::VectorXd solve(const Problem& problem, const std::stop_token& stop) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(problem.inputs.cols());
  std::vector<Eigen::Index> inside;
  for (int i = 0; i < kMaxIterations && !stop.stop_requested(); ++i) {
    const Eigen::VectorXd margins = (problem.inputs * weights).cwiseProduct(problem.targets);
    std::vector<Eigen::Index> now;
    for (Eigen::Index k = 0; k < margins.size(); ++k) {
      if (margins[k] < 1.0) now.push_back(k);
    }
    if (now == inside) break;
    inside = std::move(now);
    const Eigen::VectorXd roots = problem.costs(inside).cwiseSqrt();
    const Eigen::MatrixXd rows = roots.asDiagonal() * problem.inputs(inside, Eigen::all);
    Eigen::MatrixXd normal = problem.penalty;
    normal.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    const Eigen::VectorXd right = rows.transpose() * roots.cwiseProduct(problem.targets(inside));
    weights = normal.selfadjointView<Eigen::Lower>().llt().solve(right);
  }
  return weights;
}

void setClasses(const std::vector<bool>& positive, Problem& problem) {
  const auto positives = std::count(positive.begin(), positive.end(), true);
  const auto all = static_cast<std::ptrdiff_t>(positive.size());
  problem.targets.resize(all);
  problem.costs.resize(all);
  for (Eigen::Index i = 0; i < all; ++i) {
    const bool is_positive = positive[static_cast<std::size_t>(i)];
    problem.targets[i] = is_positive ? 1.0 : -1.0;
    problem.costs[i] = 0.5 / static_cast<double>(is_positive ? positives : all - positives);
  }
}

}  // namespace

KernelSvm::KernelSvm(SampleMatrix vectors, Eigen::VectorXf weights, float bias, float gamma)
    : vectors_(std::move(vectors)),
      weights_(std::move(weights)),
      squares_(vectors_.rowwise().squaredNorm()),
      bias_(bias),
      gamma_(gamma) {}

SampleMatrix KernelSvm::kernel(const SampleMatrix& samples) const {
  // |x − v|² = |x|² + |v|² − 2 x·v: one matrix product for all.
  SampleMatrix result = 2.0F * gamma_ * samples * vectors_.transpose();
  result.colwise() -= gamma_ * samples.rowwise().squaredNorm();
  result.rowwise() -= gamma_ * squares_.transpose();
  result = result.array().min(0.0F).exp();
  return result;
}

KernelSvm KernelSvm::train(const SampleMatrix& samples, const std::vector<bool>& positive,
                           const SvmOptions& options, const std::stop_token& stop) {
  KernelSvm svm(clusterCentres(samples, positive, options.vectors, options.seed, stop), {}, 0.0F,
                static_cast<float>(options.gamma / static_cast<double>(samples.cols())));
  const Eigen::Index vectors = svm.vectors_.rows();
  Problem problem;
  problem.inputs.resize(samples.rows(), vectors + 1);
  problem.inputs.leftCols(vectors) = svm.kernel(samples).cast<double>();
  problem.inputs.col(vectors).setOnes();
  setClasses(positive, problem);
  problem.penalty.setZero(vectors + 1, vectors + 1);
  problem.penalty.topLeftCorner(vectors, vectors) = svm.kernel(svm.vectors_).cast<double>();
  problem.penalty.diagonal().array() += kRidge;
  problem.penalty *= options.lambda;
  const Eigen::VectorXd solution = solve(problem, stop);
  svm.weights_ = solution.head(vectors).cast<float>();
  svm.bias_ = static_cast<float>(solution[vectors]);
  return svm;
}

Eigen::VectorXf KernelSvm::decide(const SampleMatrix& samples) const {
  Eigen::VectorXf distances(samples.rows());
  for (Eigen::Index from = 0; from < samples.rows(); from += kBlock) {
    const Eigen::Index count = std::min(kBlock, samples.rows() - from);
    distances.segment(from, count) =
        (kernel(samples.middleRows(from, count)) * weights_).array() + bias_;
  }
  return distances;
}

}  // namespace handmap
