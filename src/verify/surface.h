// SPDX-License-Identifier: GPL-3.0-or-later
// The abstract surface of a result: what follows from its triangles' vertex ids alone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "c1mesh/result.h"

namespace c1mesh::verification {

/// One side of an edge: the triangle that runs along it from its corner `corner` to the next.
struct Side {
  int triangle = -1, corner = -1;
  bool present() const { return triangle >= 0; }
};

/// An edge of the mesh: side[0] runs from a to b, side[1] from b to a.
struct SurfaceEdge {
  int a = -1, b = -1;
  std::array<Side, 2> side;
  bool interior() const { return side[0].present() && side[1].present(); }
};

struct Surface {
  std::vector<SurfaceEdge> edges;                  ///< by (min, max) vertex id
  std::vector<std::vector<int>> vertex_triangles;  ///< increasing
  std::vector<char> on_boundary;                   ///< per vertex
  std::vector<int> component;                      ///< per triangle; components share an edge
  int components = 0;
  /// Boundary loops as vertex ids, interior on the left; loop i bounds component loop_component[i].
  std::vector<std::vector<int>> loops;
  std::vector<int> loop_component;
  std::vector<std::string> faults;  ///< why this is not an oriented surface; else empty

  /// Index of the edge between two vertices, -1 if there is none.
  int find_edge(int a, int b) const;
};

/// Never fails: where the triangles do not form a surface, `faults` says so and the rest is
/// partial.
Surface surface_of(const Result& result);

}  // namespace c1mesh::verification
