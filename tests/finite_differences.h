// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of hand-derived gradients and Hessians against central differences.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <functional>

namespace c1mesh::testing_tools {

/// The largest error of `gradient` against central differences of `value`, relative to its norm.
inline double gradient_error(const std::function<double(const Eigen::VectorXd&)>& value,
                             const Eigen::VectorXd& gradient, const Eigen::VectorXd& x,
                             double step) {
  double worst = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd up = x, down = x;
    up[i] += step;
    down[i] -= step;
    worst = std::max(worst, std::abs((value(up) - value(down)) / (2 * step) - gradient[i]));
  }
  return worst / std::max(1.0, gradient.norm());
}

/// The largest error of `hessian` against central differences of `gradient`, relative to its norm.
inline double hessian_error(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& gradient,
                            const Eigen::MatrixXd& hessian, const Eigen::VectorXd& x, double step) {
  double worst = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Eigen::VectorXd up = x, down = x;
    up[i] += step;
    down[i] -= step;
    const Eigen::VectorXd column = (gradient(up) - gradient(down)) / (2 * step);
    worst = std::max(worst, (column - hessian.col(i)).cwiseAbs().maxCoeff());
  }
  return worst / std::max(1.0, hessian.norm());
}

}  // namespace c1mesh::testing_tools
