#include "core/pose_graph/normal_equations.h"

#include <algorithm>
#include <span>

#include "core/pose_graph/constants.h"

namespace handmap {

using namespace pose_graph;

namespace {

Eigen::SparseMatrix<double> damped(const Eigen::SparseMatrix<double>& matrix, double share) {
  Eigen::SparseMatrix<double> raised(matrix.rows(), matrix.cols());
  raised.setIdentity();
  raised.diagonal() = share * (matrix.diagonal().array().abs() + 1.0).matrix();
  return matrix + raised;
}

}  // namespace

Eigen::SparseMatrix<double> NormalEquations::matrix() const {
  Eigen::SparseMatrix<double> matrix(size(), size());
  matrix.setFromTriplets(triplets_.begin(), triplets_.end());
  return matrix;
}

/// A negative pivot is no failure to Eigen, but to what is a sum of squares.
bool NormalSolver::factorize(const Eigen::SparseMatrix<double>& matrix) {
  const std::span columns(matrix.outerIndexPtr(), static_cast<std::size_t>(matrix.cols()) + 1);
  const std::span rows(matrix.innerIndexPtr(), static_cast<std::size_t>(matrix.nonZeros()));
  if (!std::ranges::equal(columns, columns_) || !std::ranges::equal(rows, rows_)) {
    columns_.assign(columns.begin(), columns.end());
    rows_.assign(rows.begin(), rows.end());
    factor_.analyzePattern(matrix);
  }
  factor_.factorize(matrix);
  return factor_.info() == Eigen::Success && (factor_.vectorD().array() > 0.0).all();
}

std::optional<Eigen::VectorXd> NormalSolver::solve(const NormalEquations& equations, double least) {
  solved_ = false;
  const Eigen::SparseMatrix<double> matrix = equations.matrix();
  if (!matrix.diagonal().allFinite() || !equations.right().allFinite()) return std::nullopt;
  for (const double more : kDampings) {
    const double damping = std::max(least, more);
    if (!factorize(damping > 0.0 ? damped(matrix, damping) : matrix)) continue;
    Eigen::VectorXd step = factor_.solve(equations.right());
    if (factor_.info() != Eigen::Success || !step.allFinite()) continue;
    solved_ = true;
    return step;
  }
  return std::nullopt;
}

Eigen::VectorXd NormalSolver::covarianceColumn(int index) const {
  return factor_.solve(Eigen::VectorXd::Unit(factor_.rows(), index));
}

}  // namespace handmap
