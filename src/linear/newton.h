// SPDX-License-Identifier: GPL-3.0-or-later
// Damped Newton for objectives with sparse, positive semi-definite Hessians.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "linear/checkpoint.h"
#include "linear/sparse_solver.h"

namespace c1mesh {

/// A smooth function that is infinite outside its valid region.
class Objective {
 public:
  virtual ~Objective() = default;
  virtual double value(const Eigen::VectorXd& x) const = 0;
  /// Precondition: value(x) is finite. `hessian` gets the lower half of a positive semi-definite
  /// approximation (elements projected), so that Newton directions descend.
  virtual double derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient,
                             SparseMatrix& hessian) const = 0;
  /// The longest step x + t direction to try, 0 < t <= 1.
  virtual double step_limit(const Eigen::VectorXd& /*x*/,
                            const Eigen::VectorXd& /*direction*/) const {
    return 1;
  }
};

struct NewtonOptions {
  int max_iterations = 50;
  double relative_decrease = 1e-5;  ///< stop when a step gains less than this part of the value
};

struct NewtonReport {
  int iterations = 0;
  double value = 0;
  double last_step = 0;    ///< step length of the last iteration
  bool converged = false;  ///< ended by the decrease, not by the iteration limit
};

/// One step with backtracking. Returns the decrease, 0 if none was possible.
double newton_step(const Objective& objective, SparseSolver& solver, Eigen::VectorXd& x,
                   double& value, double& step);

NewtonReport newton(const Objective& objective, Eigen::VectorXd& x, const NewtonOptions& options,
                    const Checkpoint& checkpoint);

/// Gathers contributions to a symmetric sparse matrix; the order of `add` calls must be the same
/// every time, then the pattern is found once and later passes only add numbers.
class Assembler {
 public:
  void start(int size);
  /// Adds to entry (row, column); entries above the diagonal are dropped.
  void add(int row, int column, double value) {
    if (row < column) return;
    if (!built_) {
      keys_.push_back((static_cast<long long>(column) << 32) | row);
      values_.push_back(value);
    } else {
      matrix_.valuePtr()[slots_[next_++]] += value;
    }
  }
  const SparseMatrix& finish();

 private:
  void build();

  int size_ = 0;
  bool built_ = false;
  std::size_t next_ = 0;
  std::vector<long long> keys_;
  std::vector<double> values_;
  std::vector<int> slots_;
  SparseMatrix matrix_;
};

}  // namespace c1mesh
