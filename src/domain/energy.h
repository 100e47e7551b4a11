// SPDX-License-Identifier: GPL-3.0-or-later
// The domain stage's objective: distortion of every triangle and wedge, over the free unknowns.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "domain/element.h"
#include "domain/layout.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// One point a row; stored row by row, so its data are x0, y0, x1, y1, …
using PointMatrix = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;

struct DomainWeights {
  double wedge = 30;         ///< of the wedge at each C1 corner, relative to a mean triangle
  double exceptional = 0.1;  ///< of the orientation wedge at exceptional vertices
  double balance = 0.1;      ///< of the area term within each triangle's energy
};

/// Which elements a DomainElement list holds, in order: first one per triangle, then the wedges.
struct DomainElements {
  std::vector<DomainElement> all;
  int triangles = 0;
};

/// The elements of a mesh whose control points are fixed. The triangle's energy is the product of
/// the mean of |J|^2 and the mean of 1/d_k, d_k the Bernstein coefficients of det J: a smooth bound
/// from the family of g(t) that blows up before any coefficient reaches zero.
DomainElements domain_elements(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                               const DomainLayout& layout, const DomainWeights& weights);

Eigen::Matrix2d columns_of(const DomainElement& element, const PointMatrix& points);
double determinant_of(const DomainElement& element, const PointMatrix& points);

}  // namespace c1mesh
