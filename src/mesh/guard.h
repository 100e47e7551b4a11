// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a mesh fit for C1: no interior edge joins two boundary vertices.
#pragma once

#include "mesh/curved_mesh.h"

namespace c1mesh {

/// Splits every interior edge that joins two boundary vertices at its middle, in both meshes, and a
/// mesh of one triangle into three; the map stays the same. Afterwards no interior edge does so and
/// every boundary vertex has at least two triangles. Returns the number of splits.
int guard_boundary(CurvedMesh& mesh);

}  // namespace c1mesh
