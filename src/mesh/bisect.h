// SPDX-License-Identifier: GPL-3.0-or-later
// Local refinement that leaves the map as it is: chosen triangles are bisected in both meshes.
#pragma once

#include <vector>

#include "mesh/curved_mesh.h"

namespace c1mesh {

/// Bisects every triangle of `chosen` at least once, each along an edge that is longest in both
/// triangles beside it (Rivara 1997), so that neighbours are bisected too where that keeps angles.
/// An edge's length is the product of its lengths in both meshes, which no local scale changes. A
/// chosen triangle with a corner v, wide_at[v] set, whose domain angle there exceeds 25 degrees is
/// cut through v instead. New boundary vertices split their curve's parameters in the middle.
/// Triangles keep their ids (the first part), new ones are appended.
void bisect_triangles(CurvedMesh& mesh, const std::vector<int>& chosen,
                      const std::vector<char>& wide_at);

}  // namespace c1mesh
