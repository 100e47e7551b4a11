// SPDX-License-Identifier: GPL-3.0-or-later
// Splitting edges and triangles of a mesh pair without changing the map: both meshes are cut at the
// same parameters, nets by de Casteljau and blossoming. New vertices are appended.
#pragma once

#include <array>
#include <vector>

#include "bernstein/net_blossom.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// Takes a mesh apart, splits at near-constant cost each, and puts it together again in `finish`,
/// which the destructor calls; until then the mesh must not be used. Triangles keep their ids (the
/// first part) and new ones are appended. Throws std::invalid_argument for edges that do not exist.
class MeshSplitter {
 public:
  explicit MeshSplitter(CurvedMesh& mesh);
  ~MeshSplitter();
  MeshSplitter(const MeshSplitter&) = delete;
  MeshSplitter& operator=(const MeshSplitter&) = delete;

  /// Splits the interior edge a, b at t (from a); returns the new vertex. Not for feature edges.
  int split_edge(int a, int b, double t = 0.5);
  /// Splits loops[loop][index] at the middle of its curve parameters; returns the new vertex. The
  /// two halves' control points are de Casteljau's, a few roundings from the curve's.
  int split_boundary_edge(int loop, int index);
  /// The same for features[line].edges[index], in the triangles on both sides.
  int split_feature_edge(int line, int index);
  /// The same for an edge of a loop or, if `feature`, of a feature that the caller replaces in its
  /// path by the halves returned: paths are lists, and many insertions would cost their square.
  std::array<BoundaryEdge, 2> halve(const BoundaryEdge& whole, bool feature);
  /// `halve` for edges of one path at these indices, from the first of them on; they must decrease.
  void halve_all(std::vector<BoundaryEdge>& path, const std::vector<int>& indices, bool feature);
  /// The triangles around a vertex, in no promised order.
  const std::vector<int>& triangles_at(int vertex) const { return vertex_triangles_[vertex]; }
  /// Splits triangle t into three at a point strictly inside; returns the new vertex.
  int split_triangle(int t, const Barycentric& where);
  void finish();

 private:
  using Ids = std::vector<int>;
  int find_triangle(int a, int b) const;
  int new_vertex(const Point& domain, const Point& image);
  int new_triangle(bool warped);
  Ids new_points(const std::vector<Point>& points);
  Ids inner_edge_ids(int t, int a, int b) const;
  Ids interior_ids(int t) const;
  Net net(int t) const;
  const Point& point(int id) const;
  Point& point(int id);
  void write_triangle(int t, const std::array<int, 3>& corners, const Ids& ab, const Ids& bc,
                      const Ids& ca, const Ids& interior, const Net& values);
  void split_side(int t, const Net& whole, int a, int b, double t_edge, int middle,
                  const std::array<Ids, 2>& parts);
  std::array<Ids, 2> split_edge_points(int t, int a, int b, double t_edge, int& middle);

  CurvedMesh& mesh_;
  std::vector<Point> images_;  // control points of the vertices
  std::vector<Point> others_;  // all other control points; id -1 - k stands for others_[k]
  std::vector<std::vector<int>> vertex_triangles_;
  bool finished_ = false;
};

/// One split of each kind; cost linear in the mesh.
int split_edge(CurvedMesh& mesh, int a, int b, double t = 0.5);
int split_boundary_edge(CurvedMesh& mesh, int loop, int index);
int split_feature_edge(CurvedMesh& mesh, int line, int index);
/// Splits the triangle at its centroid (domain) into three; returns the new vertex.
int clough_tocher_split(CurvedMesh& mesh, int triangle);
/// Splits every triangle into four at the middles of its edges, those on curves too (new t exact).
/// Triangle t becomes 4 t (corner 0), 4 t + 1, 4 t + 2, 4 t + 3 (middle).
void refine_uniform(CurvedMesh& mesh);

}  // namespace c1mesh
