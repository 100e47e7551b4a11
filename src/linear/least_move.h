// SPDX-License-Identifier: GPL-3.0-or-later
// The least solution of A x = b for a sparse A that may have more columns than rows, and rows that
// depend on others; by SuiteSparse's QR factorisation.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "linear/sparse_solver.h"

namespace c1mesh {

/// With A^T E = Q R, the x of least norm is Q R^-T E^T b. Its error goes with the condition of A,
/// not with its square as that of the normal equations does.
class LeastMove {
 public:
  /// Rows whose distance from the span of those before is below `tolerance` are left out: they
  /// hold, to about that, where those do.
  LeastMove(const SparseMatrix& A, double tolerance);
  ~LeastMove();
  LeastMove(const LeastMove&) = delete;
  LeastMove& operator=(const LeastMove&) = delete;

  /// One right side a column. Throws std::bad_alloc if memory does not suffice.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace c1mesh
