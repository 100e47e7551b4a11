// SPDX-License-Identifier: GPL-3.0-or-later
// Records of what the stages do, for who watches: observers that measure the state they are told
// of. Where nobody does (Checkpoint::trace is empty) they hand the checkpoint on as it is.
#pragma once

#include <string>
#include <vector>

#include "domain/joints.h"
#include "linear/checkpoint.h"
#include "optimise/map_objective.h"

namespace c1mesh {

/// E_s of eq. (4.2), the sum of d_ei over the edges of `asked` (equations of joints' tips left out:
/// they say the same again), the mean f(t) of the triangles as E_reg, the largest g(t). What has no
/// value because the domain is inverted is infinite. `domain` may have more rows than vertices,
/// `control` more points than the mesh.
TraceRecord trace_record(const CurvedMesh& mesh, const std::vector<C1Edge>& asked,
                         const PointMatrix& domain, const std::vector<Point>& control);

/// Over the places of the mesh's vertices, as solve_domain tells them; the shape stays. E_s is
/// summed over the edges that these roles leave.
Checkpoint traced_domain(const Checkpoint& checkpoint, const std::string& stage,
                         const CurvedMesh& mesh, const Joints& joints, const Roles& roles);

/// Over the variables of a map's objective. The references must outlive what is returned.
Checkpoint traced_map(const Checkpoint& checkpoint, const std::string& stage,
                      const CurvedMesh& mesh, const MapObjective& objective);

/// Records get the number of vertices that give up C1.
Checkpoint traced_roles(const Checkpoint& checkpoint, const Joints& joints, const Roles& roles);

}  // namespace c1mesh
