// SPDX-License-Identifier: GPL-3.0-or-later
// The one energy of the domain stage, as a function of a 2x2 matrix D of domain vectors.
#pragma once

#include <Eigen/Core>
#include <array>

#include "c1mesh/types.h"

namespace c1mesh {

/// Columns of D are linear in three points: D = sum_k x_k [columns(k,0), columns(k,1)]. A triangle
/// (a, b, c) has D = [x_b - x_a, x_c - x_a]; wedges use other combinations.
using ElementColumns = Eigen::Matrix<double, 3, 2>;
ElementColumns triangle_columns();

/// f(D) = tr(D G D^T) / det D + balance (det D / area + area / det D).
/// With the shape fixed, the MIPS distortion |J|^2 / det J of the map from the domain, averaged in
/// the Bernstein sense over a curved triangle, is exactly of this form (see shape_metric).
struct DomainElement {
  std::array<int, 3> points{};  ///< rows of the layout
  ElementColumns columns = triangle_columns();
  Eigen::Matrix2d metric;  ///< G, symmetric positive definite, area-free
  double area = 1;         ///< reference det D, sets the scale
  double balance = 0;      ///< weight of the area term within f
  double weight = 1;       ///< weight of f^exponent in the sum
};

/// Value, gradient and Hessian with respect to vec D = (D00, D10, D01, D11).
struct ElementTerms {
  double value = 0;
  Eigen::Vector4d gradient;
  Eigen::Matrix4d hessian;
};

/// 1/det and its first two derivatives, or the regularisation of it that is finite for every det:
/// chi(d) = (d + sqrt(d^2 + eps^2)) / 2 on the relative determinant (Garanzha et al. 2021).
/// epsilon = 0 is the true function (infinite for det <= 0).
struct InverseDeterminant {
  double value, first, second;
  static InverseDeterminant at(double det, double area, double epsilon);
};

/// f^exponent with derivatives; the Hessian is exact (not projected).
ElementTerms evaluate_element(const DomainElement& element, const Eigen::Matrix2d& D,
                              double exponent, double epsilon);
double element_value(const DomainElement& element, const Eigen::Matrix2d& D, double exponent,
                     double epsilon);

/// The nearest positive semi-definite matrix (negative eigenvalues set to zero).
void project_to_semidefinite(Eigen::Matrix4d& hessian);

/// G of the energy |S D^-1|_F^2 det D / det S: the MIPS distortion of the linear map D -> S.
Eigen::Matrix2d metric_of(const Eigen::Matrix2d& S);

}  // namespace c1mesh
