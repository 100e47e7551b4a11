// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "c1mesh/c1mesh.h"
#include "mesh/initial_mesh.h"
#include "pipeline/region_input.h"

namespace c1mesh::testing_pipeline {

/// Of the first region of examples/NAME, degree 3.
inline CurvedMesh example_mesh(const std::string& name) {
  const Shape shape = make_shape(read_drawings(std::string(C1MESH_EXAMPLES) + "/" + name).at(0));
  MeshReport report;
  return initial_mesh(region_input(shape, 0, 3), {}, report);
}

}  // namespace c1mesh::testing_pipeline
