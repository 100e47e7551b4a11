// SPDX-License-Identifier: GPL-3.0-or-later
// The log-barrier of one triangle's distortion bound (paper, eq. 4.5 and section 5.1).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "bernstein/jacobian.h"

namespace c1mesh {

/// -log(bound - g_p), g_p a smooth bound of g(t) = max_i n_i / min_i d_i from above: the p-norm of
/// the positive n_i times the p-norm of the 1 / d_i. With K coefficients g <= g_p <= K^(2/p) g.
/// Coefficients of |J|^2 can be negative, and then larger in size than the largest: they are left
/// out, which is smooth where one crosses zero since p > 2.
class DistortionBarrier {
 public:
  explicit DistortionBarrier(int degree);

  double exponent = 12;  ///< p

  /// g_p over the domain triangle with edge vectors D; infinite where det D <= 0 or some d_i <= 0.
  double distortion(const Net& net, const Eigen::Matrix2d& D) const;
  /// Infinite where g_p >= bound.
  double value(const Net& net, const Eigen::Matrix2d& D, double bound) const;
  /// Value, gradient and exact Hessian in (p, vec D), size 2 net_size + 4. False where infinite.
  bool derivatives(const Net& net, const Eigen::Matrix2d& D, double bound, double& value,
                   Eigen::VectorXd& gradient, Eigen::MatrixXd& hessian) const;

  const JacobianTables& tables() const { return tables_; }

 private:
  struct Factor {
    double value;
    Eigen::VectorXd gradient;
    Eigen::MatrixXd hessian;
  };
  Eigen::VectorXd norms(const Net& net, const Eigen::Vector3d& metric) const;
  Factor norm_factor(const Net& net, const Eigen::Matrix2d& D) const;
  Factor inverse_factor(const Net& net, const Eigen::VectorXd& c) const;

  // Per coefficient the stiffness matrices: Q11 = sum uu_ij p_i.p_j, 2 Q12 with uv, Q22 with vv.
  struct Forms {
    Eigen::MatrixXd uu, uv, vv;
  };
  const JacobianTables& tables_;
  std::vector<Forms> forms_;
};

}  // namespace c1mesh
