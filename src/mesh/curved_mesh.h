// SPDX-License-Identifier: GPL-3.0-or-later
// The pair (T, T^): a curved triangle mesh of one region and its straight-edge twin.
#pragma once

#include <array>
#include <vector>

#include "c1mesh/types.h"

namespace c1mesh {

/// A boundary edge of the mesh: from vertex a to b with the interior on its left, the image of
/// curve `curve` (index into Shape::curves) over t0 -> t1 (t0 > t1 where the loop runs against it).
/// t0 and t1 are dyadic: exact.
struct BoundaryEdge {
  int a = -1, b = -1;
  int curve = -1;
  double t0 = 0, t1 = 1;
};

/// Edges inside the region that lie on feature curves and follow one another: between two ends
/// (branch points or dangling ends), or closed. BoundaryEdge serves for them too; the interior lies
/// on both sides.
struct FeatureLine {
  std::vector<BoundaryEdge> edges;
  bool closed = false;
};

/// One region's mesh in the normalised frame. `control[v]` for v < vertex count is the image of
/// vertex v; the control points of edges (n-1 each) and triangle interiors follow, each stored
/// once, in no promised order.
struct CurvedMesh {
  int degree = 3;
  std::vector<Point> domain;                     ///< T^: one point per vertex
  std::vector<std::array<int, 3>> triangles;     ///< counter-clockwise
  std::vector<Point> control;                    ///< T: all control points
  std::vector<int> nets;                         ///< flat: triangle t's ids start at t * net_size
  std::vector<std::vector<BoundaryEdge>> loops;  ///< loop 0 is the outer one; each in loop order
  std::vector<FeatureLine> features;
  std::vector<char> warped;  ///< per triangle: is its map not the identity?

  int net_size() const { return (degree + 1) * (degree + 2) / 2; }
  int vertex_count() const { return static_cast<int>(domain.size()); }
  int triangle_count() const { return static_cast<int>(triangles.size()); }
  /// Position of p_ij within a net: for j in 0..n, for i in 0..n-j.
  int net_index(int i, int j) const { return j * (degree + 1) - j * (j - 1) / 2 + i; }
  int control_id(int t, int i, int j) const { return nets[t * net_size() + net_index(i, j)]; }
};

}  // namespace c1mesh
