// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/guard.h"

#include <array>
#include <vector>

#include "mesh/split.h"
#include "mesh/topology.h"

namespace c1mesh {

int guard_boundary(CurvedMesh& mesh) {
  if (mesh.triangle_count() == 1) {
    clough_tocher_split(mesh, 0);
    return 1;
  }
  const MeshTopology topology(mesh);
  std::vector<std::array<int, 2>> joining;
  for (const MeshEdge& e : topology.edges)
    if (e.triangle[1] >= 0 && topology.on_boundary[e.a] && topology.on_boundary[e.b])
      joining.push_back({e.a, e.b});
  // The new edges of a split end in its new inner vertex: one pass is enough.
  MeshSplitter splitter(mesh);
  for (const auto& [a, b] : joining) splitter.split_edge(a, b);
  return static_cast<int>(joining.size());
}

}  // namespace c1mesh
