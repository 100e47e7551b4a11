// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "c1mesh/shape.h"
#include "mesh/initial_mesh.h"

namespace c1mesh {

/// The initial mesh of one region, in the normalised frame. Throws InputError (limit) where the
/// shape is too narrow for one, with curve and place in the input's units; and what `options.stop`
/// throws.
CurvedMesh mesh_region(const Shape& shape, int region, int degree, const MeshOptions& options,
                       MeshReport& report);

}  // namespace c1mesh
