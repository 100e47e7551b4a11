// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of the curves in the order in which one walks along them with the interior on the left.
#pragma once

#include <vector>

#include "mesh/initial_mesh.h"

namespace c1mesh::meshing {

/// One side of a curve, directed with its part of the interior on the left.
struct WalkStep {
  LoopCurve curve;
  bool feature = false;
  int path = -1, position = -1;  ///< MeshInput::loops[path][position], or features[path].curves[…]
  bool forward = true;           ///< in the direction the path has
  int walk = -1, index = -1;     ///< its own place
  int twin_walk = -1, twin_index = -1;  ///< the other side of a feature
  int start = -1, end = -1;             ///< points, numbered from 0; equal for equal bits
};

using Walks = std::vector<std::vector<WalkStep>>;

/// Each boundary curve once, each feature curve once in each direction. Without features these are
/// the loops. At a point where several curves meet, a walk goes on along the side of the same
/// sector; at a dangling end it comes back on the other side.
Walks walks_of(const MeshInput& input);

}  // namespace c1mesh::meshing
