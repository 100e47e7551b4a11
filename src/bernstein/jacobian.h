// SPDX-License-Identifier: GPL-3.0-or-later
// Bernstein forms of the Jacobian of a Bezier triangle, for any degree n: det J (degree 2n-2),
// |J|^2 (degree 2n-2) and the integral of J^T J over the triangle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// Control points of one triangle, p_ij in net order (for j in 0..n, for i in 0..n-j).
using Net = std::vector<Point>;

/// Tables for one degree. With M_ij = [a_ij, b_ij], a_ij = p_(i+1)j - p_ij, b_ij = p_i(j+1) - p_ij
/// for i+j < n, the derivative matrix over the unit triangle is n * sum_ij B_ij^(n-1) M_ij.
/// Products of two Bernstein polynomials of degree n-1 are ones of degree 2n-2 with positive
/// weights: B_a B_b = w_ab B_(a+b), w_ab = C(n-1; a) C(n-1; b) / C(2n-2; a+b) in multinomials.
class JacobianTables {
 public:
  /// The tables of degree n >= 1; built once, shared, thread-safe.
  static const JacobianTables& of(int n);

  struct Product {
    int first, second;  ///< indices of control vectors (derivative net order)
    double weight;      ///< w_ab
  };

  int degree;
  int net_size;         ///< (n+1)(n+2)/2
  int derivative_size;  ///< n(n+1)/2 control vectors a_ij (and as many b_ij)
  int det_size;         ///< (2n-1)(2n)/2 coefficients
  std::vector<int> origin, along_u,
      along_v;  ///< per derivative: net index of p_ij, p_(i+1)j, p_i(j+1)
  std::vector<std::vector<Product>> products;  ///< per coefficient: the ordered pairs that make it
  Eigen::MatrixXd mass;                        ///< derivative_size^2: n^2 * 2 * integral of B_a B_b

 private:
  explicit JacobianTables(int n);
};

/// Bernstein coefficients of det of the derivative over the unit triangle: (n a) x (n b).
Eigen::VectorXd det_coefficients(const JacobianTables& tables, const Net& net);

/// Their gradients with respect to the control points: column k is that of coefficient k, x and y
/// of control point i in rows 2i and 2i+1.
Eigen::MatrixXd det_gradients(const JacobianTables& tables, const Net& net);

/// Adds sum_k weights[k] Hessian(c_k) to the leading 2 net_size rows and columns of `hessian`. The
/// coefficients are bilinear, so their Hessians do not depend on the control points.
void add_det_hessian(const JacobianTables& tables, const Eigen::VectorXd& weights,
                     Eigen::MatrixXd& hessian);

/// Bernstein coefficients of |J|_F^2, J the Jacobian of the map from the domain triangle with edge
/// vectors (d1, d2) to the Bezier triangle.
Eigen::VectorXd norm_coefficients(const JacobianTables& tables, const Net& net, const Point& d1,
                                  const Point& d2);

/// g(t) = max n_i / min d_i (paper, before eq. 4.5); infinite where some d_i <= 0.
double distortion_bound(const JacobianTables& tables, const Net& net, const Point& d1,
                        const Point& d2);

}  // namespace c1mesh
