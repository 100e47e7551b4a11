// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a mesh fit for C1: no other edge joins two vertices of boundary or features.
#pragma once

#include "mesh/curved_mesh.h"

namespace c1mesh {

/// Splits every edge that joins two vertices on curves (boundary or features) without lying on one,
/// at its middle, in both meshes, and triangles with curves on all sides into three; the map stays
/// the same. Afterwards no edge does so, and in each sector between curves at a vertex there are at
/// least two triangles. Returns the number of splits.
int guard_boundary(CurvedMesh& mesh);

}  // namespace c1mesh
