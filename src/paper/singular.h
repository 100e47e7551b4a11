// SPDX-License-Identifier: GPL-3.0-or-later
// Singular vertices: interior, of four edges that are collinear in pairs. There the C1 equations
// depend on one another; where that is nearly so they nearly contradict (docs/paper.md).
#pragma once

#include <vector>

#include "domain/energy.h"
#include "mesh/topology.h"

namespace c1mesh {

/// Puts vertices that are singular but for `tolerance` (of their shortest edge) onto the crossing
/// of the two lines through their neighbours. `movable`: per vertex, may it move? Returns how many
/// were moved.
int make_singular(const CurvedMesh& mesh, const MeshTopology& topology,
                  const std::vector<char>& movable, double tolerance, PointMatrix& domain);

}  // namespace c1mesh
