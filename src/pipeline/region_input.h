// SPDX-License-Identifier: GPL-3.0-or-later
// From a checked shape to what the mesher takes: normalised, of one degree, directed.
#pragma once

#include "c1mesh/shape.h"
#include "mesh/initial_mesh.h"

namespace c1mesh {

/// Region `index` of the shape, its curves raised to `degree` (at least the shape's highest).
MeshInput region_input(const Shape& shape, int index, int degree);

}  // namespace c1mesh
