// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/sparse_solver.h"

#include <Eigen/CholmodSupport>
#include <new>
#include <vector>

namespace c1mesh {

struct SparseSolver::State {
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> factor;
  std::vector<int> outer, inner;  // the analysed pattern
  bool analysed = false;

  // Without memory CHOLMOD returns nothing and Eigen goes on with it.
  void require_memory() {
    if (factor.cholmod().status == CHOLMOD_OUT_OF_MEMORY) throw std::bad_alloc();
  }

  bool same_pattern(const SparseMatrix& m) const {
    return analysed && outer.size() == static_cast<std::size_t>(m.outerSize() + 1) &&
           inner.size() == static_cast<std::size_t>(m.nonZeros()) &&
           std::equal(outer.begin(), outer.end(), m.outerIndexPtr()) &&
           std::equal(inner.begin(), inner.end(), m.innerIndexPtr());
  }
};

SparseSolver::SparseSolver() : state_(std::make_unique<State>()) {
  state_->factor.cholmod().print = 0;
  // LL^T also for small systems: LDL^T would factorise indefinite ones without a word.
  state_->factor.cholmod().final_ll = 1;
}
SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

bool SparseSolver::factorise(const SparseMatrix& matrix, double shift) {
  if (!state_->same_pattern(matrix)) {
    state_->analysed = false;
    state_->factor.analyzePattern(matrix);
    state_->require_memory();
    state_->outer.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1);
    state_->inner.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
    state_->analysed = true;
  }
  state_->factor.setShift(shift);
  state_->factor.factorize(matrix);
  state_->require_memory();
  return state_->factor.info() == Eigen::Success;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd out = state_->factor.solve(right);
  state_->require_memory();
  return out;
}

bool factorise_shifted(SparseSolver& solver, const SparseMatrix& matrix, double base) {
  const double mean = matrix.diagonal().cwiseAbs().mean();
  if (!(mean > 0) || !std::isfinite(mean)) return false;
  for (double shift = base * mean; shift < 1e3 * mean; shift *= 100)
    if (solver.factorise(matrix, shift)) return true;
  return false;
}

}  // namespace c1mesh
