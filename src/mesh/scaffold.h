// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the plane that a domain leaves free, triangulated: what keeps it from overlapping.
#pragma once

#include <array>
#include <vector>

#include "mesh/curved_mesh.h"

namespace c1mesh {

struct Scaffold {
  bool crossing = false;  ///< boundary edges cross or touch where they should not, decided exactly
  std::vector<std::array<int, 3>> triangles;  ///< vertices of the mesh, counter-clockwise
};

/// Constrained Delaunay triangulation of the holes and of what lies between the outer loop and the
/// convex hull, the boundary vertices at `points` (one per mesh vertex). Empty if boundary edges
/// cross.
Scaffold make_scaffold(const CurvedMesh& mesh, const std::vector<Point>& points);

}  // namespace c1mesh
