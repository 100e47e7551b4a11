// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/guard.h"

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/split.h"
#include "mesh/topology.h"

namespace c1mesh {

int guard_boundary(CurvedMesh& mesh) {
  const MeshTopology topology(mesh);
  const std::vector<char> feature = feature_flags(mesh, topology);
  const std::vector<char> on_curve = on_curves(mesh);
  std::vector<int> surrounded;  // triangles with curves on all three sides
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& edges = topology.triangle_edges[t];
    if (std::all_of(edges.begin(), edges.end(),
                    [&](int e) { return feature[e] || topology.edges[e].triangle[1] < 0; }))
      surrounded.push_back(t);
  }
  std::vector<std::array<int, 2>> joining;
  for (std::size_t e = 0; e < topology.edges.size(); ++e) {
    const MeshEdge& edge = topology.edges[e];
    if (edge.triangle[1] >= 0 && !feature[e] && on_curve[edge.a] && on_curve[edge.b])
      joining.push_back({edge.a, edge.b});
  }
  // The new edges of a split end in its new inner vertex: one pass is enough.
  MeshSplitter splitter(mesh);
  for (const int t : surrounded) splitter.split_triangle(t, Barycentric::Constant(1.0 / 3));
  for (const auto& [a, b] : joining) splitter.split_edge(a, b);
  return static_cast<int>(surrounded.size() + joining.size());
}

}  // namespace c1mesh
