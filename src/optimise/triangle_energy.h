// SPDX-License-Identifier: GPL-3.0-or-later
// The distortion energy of one curved triangle over its domain triangle, both variable.
#pragma once

#include <Eigen/Core>
#include <memory>

#include "bernstein/jacobian.h"

namespace c1mesh {

/// f(p, D) = mean(|J|^2) * mean_k(1 / d_k), J = M D^-1 the Jacobian of phi, d_k the Bernstein
/// coefficients of det J. It lies between 2 (a similarity) and g(t) of eq. (4.5), and is infinite
/// as soon as any coefficient reaches zero. Written as f = q h with q = <S(D), Q(p)>, Q = mean(M^T
/// M), S = adj(D) adj(D)^T / det D and h = mean_k(1 / c_k), c_k the coefficients of det M.
/// Derivatives are with respect to (p, vec D): x and y of control point k at 2k and 2k+1, then
/// D00, D10, D01, D11.
class TriangleEnergy {
 public:
  explicit TriangleEnergy(int degree);

  /// Infinite where det D <= 0 or some coefficient <= 0.
  double value(const Net& net, const Eigen::Matrix2d& D) const;

  /// Value, gradient and exact Hessian (size 2 net_size + 4). False outside the valid region.
  bool derivatives(const Net& net, const Eigen::Matrix2d& D, double& value,
                   Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const;

  int size() const { return 2 * tables_.net_size + 4; }
  const JacobianTables& tables() const { return tables_; }

 private:
  void inverse_mean(const Net& net, const Eigen::VectorXd& c, double& h, Eigen::VectorXd& gradient,
                    Eigen::MatrixXd& hessian) const;

  const JacobianTables& tables_;
  Eigen::MatrixXd uu_, uv_,
      vv_;  // stiffness: Q11 = sum uu_ij p_i.p_j, 2 Q12 = sum uv_ij p_i.p_j, …
};

/// Replaces a symmetric matrix by its nearest positive semi-definite one.
void project_to_semidefinite(Eigen::MatrixXd& hessian);

}  // namespace c1mesh
