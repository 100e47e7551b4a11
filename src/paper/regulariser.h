// SPDX-License-Identifier: GPL-3.0-or-later
// E_reg of one triangle (paper, eq. 4.3): how far its control net is from that of the domain
// triangle before the optimisation.
#pragma once

#include <Eigen/Core>

#include "bernstein/jacobian.h"

namespace c1mesh {

/// A sum_(i+j<n) R_ij, R_ij = |J_ij|_F^2 + |J_ij^-1|_F^2, J_ij = M_ij M^-1 with M_ij = [a_ij, b_ij]
/// the control vectors and M those of the straight domain triangle [d1, d2] of area A. R has a pole
/// where det J_ij = 0, which a control vector pair of a regular triangle may cross: below det J =
/// kGuard, 1 / det^2 goes on as its second-order Taylor polynomial.
class Regulariser {
 public:
  static constexpr double kGuard = 0.1;

  Regulariser(const JacobianTables& tables, const Point& d1, const Point& d2);

  double value(const Net& net) const;
  /// Adds weight * E_reg's gradient and its Hessian, each R_ij's made positive semi-definite if
  /// `project`, to the leading 2 net_size entries. Returns weight * E_reg.
  double add(const Net& net, double weight, bool project, Eigen::VectorXd& gradient,
             Eigen::MatrixXd& hessian) const;

 private:
  Eigen::Matrix2d jacobian(const Net& net, int k) const;

  const JacobianTables* tables_;
  Eigen::Matrix2d inverse_;  // M^-1
  double area_;
};

/// 1 / x^2 and its first two derivatives, guarded.
struct InverseSquare {
  double value, first, second;
  explicit InverseSquare(double x);
};

}  // namespace c1mesh
