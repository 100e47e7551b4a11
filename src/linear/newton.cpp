// SPDX-License-Identifier: GPL-3.0-or-later
#include "linear/newton.h"

#include <algorithm>
#include <cmath>

namespace c1mesh {

double newton_step(const Objective& objective, SparseSolver& solver, Eigen::VectorXd& x,
                   double& value, double& step) {
  Eigen::VectorXd gradient;
  SparseMatrix hessian;
  step = 0;
  value = objective.derivatives(x, gradient, hessian);
  if (!factorise_shifted(solver, hessian, 1e-12)) return 0;
  const Eigen::VectorXd direction = -solver.solve(gradient);
  const double slope = gradient.dot(direction);
  if (!(slope < 0)) return 0;
  // Backtracking halves; far from validity a quarter saves evaluations.
  for (double trial = objective.step_limit(x, direction); trial > 1e-10; trial *= 0.5) {
    const Eigen::VectorXd there = x + trial * direction;
    const double f = objective.value(there);
    if (f <= value + 1e-4 * trial * slope) {
      const double decrease = value - f;
      x = there;
      value = f;
      step = trial;
      return decrease;
    }
    if (!std::isfinite(f)) trial *= 0.5;
  }
  return 0;
}

NewtonReport newton(const Objective& objective, Eigen::VectorXd& x, const NewtonOptions& options,
                    const Checkpoint& checkpoint) {
  NewtonReport report;
  SparseSolver solver;
  while (report.iterations < options.max_iterations) {
    if (checkpoint) checkpoint();
    const double decrease = newton_step(objective, solver, x, report.value, report.last_step);
    ++report.iterations;
    if (checkpoint.observe) checkpoint.observe(x, report.last_step);
    if (decrease <= options.relative_decrease * std::abs(report.value)) {
      report.converged = true;
      break;
    }
  }
  return report;
}

void Assembler::start(int size) {
  if (built_ && size == size_) {
    std::fill_n(matrix_.valuePtr(), matrix_.nonZeros(), 0.0);
  } else {
    size_ = size;
    built_ = false;
    keys_.clear();
    values_.clear();
  }
  next_ = 0;
}

void Assembler::build() {
  std::vector<long long> unique = keys_;
  std::sort(unique.begin(), unique.end());
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  matrix_.resize(size_, size_);
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(unique.size()));
  std::vector<int> count(size_ + 1, 0);
  for (std::size_t k = 0; k < unique.size(); ++k) {
    matrix_.innerIndexPtr()[k] = static_cast<int>(unique[k] & 0xffffffff);
    ++count[(unique[k] >> 32) + 1];
    matrix_.valuePtr()[k] = 0;
  }
  for (int c = 0; c < size_; ++c) count[c + 1] += count[c];
  std::copy(count.begin(), count.end(), matrix_.outerIndexPtr());
  slots_.resize(keys_.size());
  for (std::size_t k = 0; k < keys_.size(); ++k) {
    slots_[k] =
        static_cast<int>(std::lower_bound(unique.begin(), unique.end(), keys_[k]) - unique.begin());
    matrix_.valuePtr()[slots_[k]] += values_[k];
  }
  built_ = true;
}

const SparseMatrix& Assembler::finish() {
  if (!built_) build();
  return matrix_;
}

}  // namespace c1mesh
