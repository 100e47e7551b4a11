// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimise/inverse_metric.h"

namespace c1mesh {

InverseMetric inverse_metric(const Eigen::Matrix2d& D) {
  const Point a = D.col(0), b = D.col(1);
  const double det = cross(a, b);
  const Eigen::Vector3d top(b.squaredNorm(), -a.dot(b), a.squaredNorm());
  Eigen::Matrix<double, 3, 4> d_top;
  d_top << 0, 0, 2 * b.x(), 2 * b.y(),  //
      -b.x(), -b.y(), -a.x(), -a.y(),   //
      2 * a.x(), 2 * a.y(), 0, 0;
  const Eigen::RowVector4d d_det(b.y(), -b.x(), -a.y(), a.x());
  InverseMetric S;
  S.value = top / det;
  S.gradient = (d_top - S.value * d_det) / det;
  return S;
}

// With N = s . top quadratic,
// H = H_N / det - (dN d_det^T + d_det dN^T) / det^2 + 2 N d_det d_det^T / det^3 - N H_det / det^2.
Eigen::Matrix4d inverse_metric_hessian(const Eigen::Vector3d& s, const Eigen::Matrix2d& D) {
  const Point a = D.col(0), b = D.col(1);
  const double det = cross(a, b);
  const double N = s[0] * b.squaredNorm() - s[1] * a.dot(b) + s[2] * a.squaredNorm();
  Eigen::Vector4d dN, dd(b.y(), -b.x(), -a.y(), a.x());
  dN << 2 * s[2] * a - s[1] * b, 2 * s[0] * b - s[1] * a;
  Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
  H.diagonal() << 2 * s[2], 2 * s[2], 2 * s[0], 2 * s[0];
  H(0, 2) = H(2, 0) = H(1, 3) = H(3, 1) = -s[1];
  H /= det;
  H += -(dN * dd.transpose() + dd * dN.transpose()) / (det * det) +
       2 * N / (det * det * det) * dd * dd.transpose();
  const double curl = N / (det * det);
  H(0, 3) -= curl;
  H(3, 0) -= curl;
  H(1, 2) += curl;
  H(2, 1) += curl;
  return H;
}

}  // namespace c1mesh
