// SPDX-License-Identifier: GPL-3.0-or-later
// The simple closed runs of edges on curves that bound the faces between boundary and features: the
// image of each in the domain is a polygon, which needs three corners of its own.
#pragma once

#include <vector>

#include "domain/joints.h"

namespace c1mesh {

/// A vertex of a cycle and the path along which the cycle leaves it.
struct CycleStop {
  int vertex = -1;
  int path = -1, position = -1;  ///< the vertex in joints[path][position]
  bool forward = true;           ///< the cycle leaves it in the path's direction
};

/// Directed with the face on its left. `inside`: the face lies inside the cycle, whose polygon then
/// needs three corners that turn left; otherwise around it, and three must turn right.
struct Cycle {
  std::vector<CycleStop> stops;
  bool inside = true;
};

/// All of them, found by walking around every face and cutting the walks where they come back to a
/// vertex; what is run to and fro (dangling features) is left out. Order of the mesh's paths.
std::vector<Cycle> face_cycles(const CurvedMesh& mesh);

}  // namespace c1mesh
