// SPDX-License-Identifier: GPL-3.0-or-later
#include "domain/element.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace c1mesh {
namespace {

// The Hessian of det D in the order (D00, D10, D01, D11).
Eigen::Matrix4d det_hessian() {
  Eigen::Matrix4d H = Eigen::Matrix4d::Zero();
  H(0, 3) = H(3, 0) = 1;
  H(1, 2) = H(2, 1) = -1;
  return H;
}

}  // namespace

ElementColumns triangle_columns() {
  ElementColumns c;
  c << -1, -1, 1, 0, 0, 1;
  return c;
}

InverseDeterminant InverseDeterminant::at(double det, double area, double epsilon) {
  if (epsilon == 0) {
    if (!(det > 0)) return {std::numeric_limits<double>::infinity(), 0, 0};
    return {1 / det, -1 / (det * det), 2 / (det * det * det)};
  }
  const double d = det / area, root = std::hypot(d, epsilon);
  // (d + root)/2 cancels for d < 0; the conjugate form does not.
  const double chi = d >= 0 ? 0.5 * (d + root) : 0.5 * epsilon * epsilon / (root - d);
  const double chi1 = chi / root;
  const double chi2 = 0.5 * epsilon * epsilon / (root * root * root);
  const double v = 1 / (area * chi);
  return {v, -v * chi1 / (chi * area),
          v * (2 * chi1 * chi1 / (chi * chi) - chi2 / chi) / (area * area)};
}

double element_value(const DomainElement& e, const Eigen::Matrix2d& D, double exponent,
                     double epsilon) {
  const double det = D(0, 0) * D(1, 1) - D(1, 0) * D(0, 1);
  const InverseDeterminant inverse = InverseDeterminant::at(det, e.area, epsilon);
  if (!std::isfinite(inverse.value)) return inverse.value;
  const double norm = (D * e.metric).cwiseProduct(D).sum();
  const double f = (norm + e.balance * e.area) * inverse.value + e.balance * det / e.area;
  return std::pow(f, exponent);
}

ElementTerms evaluate_element(const DomainElement& e, const Eigen::Matrix2d& D, double exponent,
                              double epsilon) {
  ElementTerms out;
  const double det = D(0, 0) * D(1, 1) - D(1, 0) * D(0, 1);
  const InverseDeterminant inverse = InverseDeterminant::at(det, e.area, epsilon);
  const Eigen::Matrix2d DG = D * e.metric;
  const double top = DG.cwiseProduct(D).sum() + e.balance * e.area;
  const Eigen::Vector4d dn(2 * DG(0, 0), 2 * DG(1, 0), 2 * DG(0, 1), 2 * DG(1, 1));
  const Eigen::Vector4d dd(D(1, 1), -D(0, 1), -D(1, 0), D(0, 0));
  static const Eigen::Matrix4d kDet = det_hessian();

  out.value = top * inverse.value + e.balance * det / e.area;
  out.gradient = inverse.value * dn + (top * inverse.first + e.balance / e.area) * dd;
  out.hessian = inverse.first * (dn * dd.transpose() + dd * dn.transpose()) +
                top * inverse.second * dd * dd.transpose() +
                (top * inverse.first + e.balance / e.area) * kDet;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int k = 0; k < 2; ++k)
        out.hessian(2 * a + k, 2 * b + k) += 2 * inverse.value * e.metric(a, b);
  if (exponent != 1) {
    const double p = exponent, f = out.value, power = std::pow(f, p - 2);
    out.hessian = p * power * (f * out.hessian + (p - 1) * out.gradient * out.gradient.transpose());
    out.gradient *= p * power * f;
    out.value = power * f * f;
  }
  return out;
}

void project_to_semidefinite(Eigen::Matrix4d& hessian) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(hessian);
  if (eigen.eigenvalues()[0] >= 0) return;
  hessian = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
            eigen.eigenvectors().transpose();
}

Eigen::Matrix2d metric_of(const Eigen::Matrix2d& S) {
  Eigen::Matrix2d G;
  const double off = -S.col(0).dot(S.col(1));
  G << S.col(1).squaredNorm(), off, off, S.col(0).squaredNorm();
  return G / S.determinant();
}

}  // namespace c1mesh
