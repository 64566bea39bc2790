// The normal equations of a least-squares problem, and their solution.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/SparseCholesky>

#include "core/pose_graph/factor.h"

namespace handmap {

/// Collected factor by factor. A matrix is symmetric: its lower triangle is kept alone.
class NormalEquations {
 public:
  /// Some consecutive unknowns. Those at less than 0 stay as they are.
  struct Unknowns {
    int at;
    int size;
  };

  explicit NormalEquations(int size) : right_(Eigen::VectorXd::Zero(size)) {}

  int size() const { return static_cast<int>(right_.size()); }
  void add(int row, int column, double value) { triplets_.emplace_back(row, column, value); }
  /// Adds what of a block lies in the lower triangle.
  template <typename Block>
  void addBlock(int row, int column, const Block& block) {
    for (int i = 0; i < block.rows(); ++i) {
      for (int j = 0; j < block.cols(); ++j) {
        if (row + i >= column + j) triplets_.emplace_back(row + i, column + j, block(i, j));
      }
    }
  }
  auto right(const Unknowns& some) { return right_.segment(some.at, some.size); }
  double& right(int at) { return right_[at]; }
  const Eigen::VectorXd& right() const { return right_; }

  /// Equations of some unknowns, one after the other.
  template <typename Matrix, typename Vector, std::size_t Count>
  void add(const Matrix& matrix, const Vector& right, const std::array<Unknowns, Count>& all) {
    int row = 0;
    for (const Unknowns& to : all) {
      int column = 0;
      for (const Unknowns& from : all) {
        for (int i = 0; from.at >= 0 && to.at >= from.at && i < to.size; ++i) {
          for (int j = 0; j < from.size; ++j) {
            if (to.at + i < from.at + j) continue;
            add(to.at + i, from.at + j, matrix(row + i, column + j));
          }
        }
        column += from.size;
      }
      for (int i = 0; to.at >= 0 && i < to.size; ++i) right_[to.at + i] += right[row + i];
      row += to.size;
    }
  }
  template <int Rows, int Size, std::size_t Count>
  void add(const Factor<Rows, Size>& factor, const std::array<Unknowns, Count>& all) {
    const Eigen::Matrix<double, Size, Rows> weighted =
        factor.jacobian.transpose() * factor.weight.asDiagonal();
    const Eigen::Matrix<double, Size, Size> matrix = weighted * factor.jacobian;
    const Eigen::Matrix<double, Size, 1> right = -weighted * factor.residual;
    add(matrix, right, all);
  }

  template <int Size, std::size_t Count>
  void add(const ScalarFactor<Size>& factor, const std::array<Unknowns, Count>& all) {
    const Eigen::Matrix<double, Size, Size> matrix =
        factor.weight * factor.slope * factor.slope.transpose();
    const Eigen::Matrix<double, Size, 1> right = -factor.weight * factor.residual * factor.slope;
    add(matrix, right, all);
  }

  Eigen::SparseMatrix<double> matrix() const;

 private:
  std::vector<Eigen::Triplet<double>> triplets_;
  Eigen::VectorXd right_;
};

/// Solves normal equations by a sparse Cholesky factor (LDLᵀ).
class NormalSolver {
 public:
  /// The step to take. The diagonal is raised by `least` of itself and of 1, and where the
  /// equations do not determine all unknowns, or rounding has it so, by more (Levenberg); nullopt
  /// where that does not help or a number is not finite.
  std::optional<Eigen::VectorXd> solve(const NormalEquations& equations, double least = 0.0);
  /// Whether the last solve() did: the covariance is known.
  bool isSolved() const { return solved_; }
  /// Of the covariance of the unknowns. Only where isSolved().
  Eigen::VectorXd covarianceColumn(int index) const;

 private:
  bool factorize(const Eigen::SparseMatrix<double>& matrix);

  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  std::vector<int> columns_;  ///< of the matrix that was ordered last, where they begin
  std::vector<int> rows_;     ///< and the rows in them
  bool solved_ = false;
};

}  // namespace handmap
