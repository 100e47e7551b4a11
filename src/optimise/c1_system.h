// SPDX-License-Identifier: GPL-3.0-or-later
// The C1 conditions across interior edges (paper, section 4.2): residues, derivatives, the linear
// system over the control points, and the projection onto its solutions.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "domain/energy.h"
#include "domain/layout.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// One interior edge (v0, v1) of t = (v0, v1, v2) and t' = (v1, v0, v3). Equations that say the
/// same over auxiliary points (see joint_equations) have fewer than n entries in inner and outer.
struct C1Edge {
  std::array<int, 4> vertex{};  ///< v0, v1, v2, v3
  std::vector<int> edge;        ///< n+1 control ids along the edge from v0 to v1: p_0i
  std::vector<int> inner;       ///< n ids of t's row next to it: p_1i
  std::vector<int> outer;       ///< n ids of t''s row next to it, outer[i] = p'_1(n-i-1)

  int equations() const { return static_cast<int>(inner.size()); }
};

/// Every interior edge that is no feature edge, in the topology's order.
std::vector<C1Edge> c1_edges(const CurvedMesh& mesh);

/// At a mild joint the two boundary edges are nearly parallel and pin the gradient only weakly
/// through the edges' own equations. These say it well: for every edge (v, j) of them there, the
/// control point next to v is where the map (e0, w) -> (d0, J d0) sends (x_j - x_v) / n. Appends
/// the auxiliary control points v + d0/n and v + J d0/n to `control`.
std::vector<C1Edge> joint_equations(const CurvedMesh& mesh, const Joints& joints,
                                    const DomainLayout& layout, std::vector<Point>& control);

/// Barycentric coordinates of v3 in (v0, v1, v2): (g0, g1, g2); g2 < 0 in a valid mesh.
Eigen::Vector3d barycentric(const Point& v0, const Point& v1, const Point& v2, const Point& v3);

/// The same of an edge's vertices over the domain.
Eigen::Vector3d edge_barycentric(const C1Edge& edge, const PointMatrix& domain);

/// d(g1, g2) with respect to the coordinates of v0 … v3 (2 x 8); g0 = 1 - g1 - g2.
Eigen::Matrix<double, 2, 8> barycentric_derivative(const Point& v0, const Point& v1,
                                                   const Point& v2, const Point& v3);

/// outer[i] - (g0 edge[i] + g1 edge[i+1] + g2 inner[i]); its norm is d_(e,i) of eq. (4.1).
Point c1_residue(const C1Edge& edge, int i, const Eigen::Vector3d& g,
                 const std::vector<Point>& control);

/// The largest d_(e,i) over `edges`.
double largest_residue(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                       const std::vector<Point>& control);

/// The rows of A with A p = 0 iff C1 holds across `edges`: n rows per edge, one column per control
/// point (the same for x and y). Row e*n + i has the coefficients of c1_residue.
Eigen::SparseMatrix<double, Eigen::RowMajor> c1_matrix(const std::vector<C1Edge>& edges,
                                                       const PointMatrix& domain, int controls);

struct ProjectionReport {
  double before = 0, after = 0;  ///< largest residue
  double largest_move = 0;       ///< how far a control point went
  int rounds = 0;
};

/// Moves the free control points as little as possible (each measured by `size`, its local length)
/// so that every equation holds to rounding. Residues are summed in extended precision, so the
/// result is as good as the doubles that hold it.
ProjectionReport project_to_c1(const std::vector<C1Edge>& edges, const PointMatrix& domain,
                               const std::vector<char>& fixed, const std::vector<double>& size,
                               std::vector<Point>& control);

}  // namespace c1mesh
