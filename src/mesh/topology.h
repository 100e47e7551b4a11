// SPDX-License-Identifier: GPL-3.0-or-later
// Who is next to whom in a CurvedMesh, and a check of everything a mesh must satisfy.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "bernstein/jacobian.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// One edge of the mesh.
struct MeshEdge {
  int a = -1, b = -1;                   ///< vertices; a -> b is counter-clockwise in triangle[0]
  std::array<int, 2> triangle{-1, -1};  ///< triangle[1] = -1 on the boundary
  std::array<int, 2> corner{-1, -1};    ///< local index of the corner OPPOSITE the edge in each
};

/// Adjacency of a mesh, built from `triangles` alone. Edges are in order of first appearance
/// (triangle by triangle, the edge opposite corner 2, then 0, then 1), so the order is
/// reproducible. An edge with more than two triangles keeps the first two; check_mesh reports it.
struct MeshTopology {
  std::vector<MeshEdge> edges;
  std::vector<std::array<int, 3>> triangle_edges;  ///< [t][k]: the edge opposite corner k
  std::vector<std::vector<int>> vertex_triangles;  ///< increasing triangle ids
  std::vector<char> on_boundary;  ///< per vertex: is it on an edge of one triangle?

  explicit MeshTopology(const CurvedMesh& mesh);
};

/// Per edge of the topology: does it lie on a feature?
std::vector<char> feature_flags(const CurvedMesh& mesh, const MeshTopology& topology);

/// Per vertex: does it lie on the boundary or on a feature?
std::vector<char> on_curves(const CurvedMesh& mesh);

/// The control ids of triangle t's edge opposite corner k, from corner k+1 to corner k+2 (mod 3):
/// degree + 1 ids, ends included.
std::vector<int> edge_controls(const CurvedMesh& mesh, int t, int k);

/// The control points of triangle t in net order.
Net net_of(const CurvedMesh& mesh, int t);

/// g(t) of eq. (4.5) for triangle t over its own domain triangle; infinite if not proven regular.
double triangle_bound(const CurvedMesh& mesh, int t);

/// Every violated invariant in words; empty for a sound mesh. Checked: indices in range, vertex ids
/// at the corners of the nets, counter-clockwise domain triangles, edges shared by at most two
/// triangles with the same control ids, one fan per vertex, all det coefficients positive, loops
/// closed and made of exactly the boundary edges, Euler characteristic 2 - loops.
std::vector<std::string> check_mesh(const CurvedMesh& mesh);

}  // namespace c1mesh
