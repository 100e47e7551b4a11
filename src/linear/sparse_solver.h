// SPDX-License-Identifier: GPL-3.0-or-later
// Sparse symmetric positive definite systems, factorised by CHOLMOD.
#pragma once

#include <Eigen/SparseCore>
#include <memory>

namespace c1mesh {

using SparseMatrix =
    Eigen::SparseMatrix<double>;  ///< column-major; symmetric ones keep the lower half

/// Keeps the symbolic analysis while the sparsity pattern stays the same.
class SparseSolver {
 public:
  SparseSolver();
  ~SparseSolver();
  SparseSolver(SparseSolver&&) noexcept;
  SparseSolver& operator=(SparseSolver&&) noexcept;

  /// Factorises the lower half `matrix` + shift I; false if it is not positive definite.
  bool factorise(const SparseMatrix& matrix, double shift);
  /// Precondition: factorise returned true.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Adds the smallest shift of the series base, 10 base, 100 base, … that makes the matrix positive
/// definite (times the mean diagonal); returns false if even a dominating shift fails (NaN
/// entries).
bool factorise_shifted(SparseSolver& solver, const SparseMatrix& matrix, double base);

}  // namespace c1mesh
