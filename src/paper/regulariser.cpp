// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper/regulariser.h"

#include <Eigen/LU>
#include <array>

#include "domain/element.h"

namespace c1mesh {

InverseSquare::InverseSquare(double x) {
  const double guard = Regulariser::kGuard, at = x > guard ? x : guard, beyond = x - at;
  value = 1 / (at * at);
  first = -2 * value / at;
  second = 6 * value / (at * at);
  value += beyond * (first + 0.5 * beyond * second);
  first += beyond * second;
}

Regulariser::Regulariser(const JacobianTables& tables, const Point& d1, const Point& d2)
    : tables_(&tables), area_(0.5 * cross(d1, d2)) {
  Eigen::Matrix2d M;
  M << d1, d2;
  inverse_ = tables.degree * M.inverse();
}

Eigen::Matrix2d Regulariser::jacobian(const Net& net, int k) const {
  Eigen::Matrix2d M;
  M << net[tables_->along_u[k]] - net[tables_->origin[k]],
      net[tables_->along_v[k]] - net[tables_->origin[k]];
  return M * inverse_;
}

// In two dimensions |J^-1|^2 = |J|^2 / det^2.
double Regulariser::value(const Net& net) const {
  double sum = 0;
  for (int k = 0; k < tables_->derivative_size; ++k) {
    const Eigen::Matrix2d J = jacobian(net, k);
    sum += J.squaredNorm() * (1 + InverseSquare(J.determinant()).value);
  }
  return area_ * sum;
}

double Regulariser::add(const Net& net, double weight, bool project, Eigen::VectorXd& gradient,
                        Eigen::MatrixXd& hessian) const {
  double sum = 0;
  for (int k = 0; k < tables_->derivative_size; ++k) {
    const Eigen::Matrix2d J = jacobian(net, k);
    const Eigen::Vector4d j(J(0, 0), J(1, 0), J(0, 1), J(1, 1));
    const Eigen::Vector4d slope(j[3], -j[2], -j[1], j[0]);  // of det J
    const double q = J.squaredNorm();
    const InverseSquare h(J.determinant());
    sum += q * (1 + h.value);
    const Eigen::Vector4d dj = 2 * (1 + h.value) * j + q * h.first * slope;
    Eigen::Matrix4d H = 2 * h.first * (j * slope.transpose() + slope * j.transpose()) +
                        q * h.second * slope * slope.transpose();
    H.diagonal().array() += 2 * (1 + h.value);
    H(0, 3) += q * h.first;
    H(3, 0) += q * h.first;
    H(1, 2) -= q * h.first;
    H(2, 1) -= q * h.first;
    if (project) project_to_semidefinite(H);
    // J = M inverse: column c of J is a inverse(0, c) + b inverse(1, c).
    const std::array<int, 3> at{tables_->origin[k], tables_->along_u[k], tables_->along_v[k]};
    std::array<Eigen::RowVector2d, 3> factor;
    factor[1] = inverse_.row(0);
    factor[2] = inverse_.row(1);
    factor[0] = -factor[1] - factor[2];
    for (int a = 0; a < 3; ++a) {
      gradient.segment<2>(2 * at[a]) +=
          weight * area_ * (factor[a][0] * dj.head<2>() + factor[a][1] * dj.tail<2>());
      for (int b = 0; b < 3; ++b)
        for (int c = 0; c < 2; ++c)
          for (int d = 0; d < 2; ++d)
            hessian.block<2, 2>(2 * at[a], 2 * at[b]) +=
                weight * area_ * factor[a][c] * factor[b][d] * H.block<2, 2>(2 * c, 2 * d);
    }
  }
  return weight * area_ * sum;
}

}  // namespace c1mesh
