// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/least_move.h"

#include <SuiteSparseQR.hpp>
#include <new>

#include "linear/one_thread.h"

namespace c1mesh {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, SuiteSparse_long>;

// A view; `matrix` must outlive it.
cholmod_sparse view_of(Sparse& matrix) {
  cholmod_sparse out{};
  out.nrow = static_cast<std::size_t>(matrix.rows());
  out.ncol = static_cast<std::size_t>(matrix.cols());
  out.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  out.p = matrix.outerIndexPtr();
  out.i = matrix.innerIndexPtr();
  out.x = matrix.valuePtr();
  out.stype = 0;
  out.itype = CHOLMOD_LONG;
  out.xtype = CHOLMOD_REAL;
  out.dtype = CHOLMOD_DOUBLE;
  out.sorted = 1;
  out.packed = 1;
  return out;
}

cholmod_dense view_of(Eigen::MatrixXd& matrix) {
  cholmod_dense out{};
  out.nrow = static_cast<std::size_t>(matrix.rows());
  out.ncol = static_cast<std::size_t>(matrix.cols());
  out.nzmax = out.nrow * out.ncol;
  out.d = out.nrow;
  out.x = matrix.data();
  out.xtype = CHOLMOD_REAL;
  out.dtype = CHOLMOD_DOUBLE;
  return out;
}

}  // namespace

struct LeastMove::State {
  cholmod_common common{};
  Sparse transposed;
  SuiteSparseQR_factorization<double>* factor = nullptr;

  State() {
    cholmod_l_start(&common);
    common.print = 0;
  }
  ~State() {
    SuiteSparseQR_free(&factor, &common);
    cholmod_l_finish(&common);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

LeastMove::LeastMove(const SparseMatrix& A, double tolerance) : state_(std::make_unique<State>()) {
  const OneThread one_thread;
  state_->transposed = Sparse(SparseMatrix(A.transpose()));
  state_->transposed.makeCompressed();
  cholmod_sparse view = view_of(state_->transposed);
  state_->factor =
      SuiteSparseQR_factorize<double>(SPQR_ORDERING_DEFAULT, tolerance, &view, &state_->common);
  if (!state_->factor) throw std::bad_alloc();
}

LeastMove::~LeastMove() = default;

Eigen::MatrixXd LeastMove::solve(const Eigen::MatrixXd& right) const {
  Eigen::MatrixXd copy = right;
  cholmod_dense view = view_of(copy);
  cholmod_common* common = &state_->common;
  cholmod_dense* reduced = SuiteSparseQR_solve(SPQR_RTX_EQUALS_ETB, state_->factor, &view, common);
  if (!reduced) throw std::bad_alloc();
  cholmod_dense* least = SuiteSparseQR_qmult(SPQR_QX, state_->factor, reduced, common);
  cholmod_l_free_dense(&reduced, common);
  if (!least) throw std::bad_alloc();
  const Eigen::MatrixXd out = Eigen::Map<const Eigen::MatrixXd>(
      static_cast<const double*>(least->x), static_cast<Eigen::Index>(least->nrow),
      static_cast<Eigen::Index>(least->ncol));
  cholmod_l_free_dense(&least, common);
  return out;
}

}  // namespace c1mesh
