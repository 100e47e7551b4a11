// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/sparse_solver.h"

#include <Eigen/CholmodSupport>
#include <vector>

#include "c1mesh/cost.h"

// OpenMP's, there if CHOLMOD was built with it. Weak: this library does not ask for OpenMP.
extern "C" {
__attribute__((weak)) int omp_get_max_active_levels();
__attribute__((weak)) void omp_set_max_active_levels(int levels);
}

namespace c1mesh {
namespace {

// CHOLMOD opens parallel regions of a fixed number of threads around many small blocks, whatever
// number of threads was asked for. On a machine with other work they wait for each other far longer
// than they work.
class OneThread {
 public:
  OneThread() {
    if (!omp_set_max_active_levels || !omp_get_max_active_levels) return;
    before_ = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
  }
  ~OneThread() {
    if (before_ >= 0) omp_set_max_active_levels(before_);
  }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int before_ = -1;
};

}  // namespace

struct SparseSolver::State {
  Eigen::CholmodDecomposition<SparseMatrix, Eigen::Lower> factor;
  std::vector<int> outer, inner;  // the analysed pattern
  bool analysed = false;

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
  const OneThread one_thread;
  if (!state_->same_pattern(matrix)) {
    const StageTimer timer("map: ordering");
    state_->factor.analyzePattern(matrix);
    state_->outer.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.outerSize() + 1);
    state_->inner.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
    state_->analysed = true;
  }
  const StageTimer timer("map: factorisation");
  state_->factor.setShift(shift);
  state_->factor.factorize(matrix);
  return state_->factor.info() == Eigen::Success;
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right) const {
  const StageTimer timer("map: triangular solves");
  const OneThread one_thread;
  return state_->factor.solve(right);
}

bool factorise_shifted(SparseSolver& solver, const SparseMatrix& matrix, double base) {
  const double mean = matrix.diagonal().cwiseAbs().mean();
  if (!(mean > 0) || !std::isfinite(mean)) return false;
  for (double shift = base * mean; shift < 1e3 * mean; shift *= 100)
    if (solver.factorise(matrix, shift)) return true;
  return false;
}

}  // namespace c1mesh
