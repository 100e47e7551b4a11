// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mesh_region.h"

#include "mesh/no_mesh.h"
#include "pipeline/region_input.h"

namespace c1mesh {

CurvedMesh mesh_region(const Shape& shape, int region, int degree, const MeshOptions& options,
                       MeshReport& report) {
  try {
    return initial_mesh(region_input(shape, region, degree), options, report);
  } catch (const NoMesh& error) {
    Defect defect;
    defect.kind = DefectKind::limit;
    defect.message = std::string("the shape cannot be meshed: ") + error.what();
    defect.remedy = "move curves apart where the shape is narrowest";
    if (error.curve >= 0) {
      defect.curves = {shape.curve_ids[error.curve]};
      defect.where = {shape.frame.restore(error.where)};
    }
    throw InputError({defect});
  }
}

}  // namespace c1mesh
