// SPDX-License-Identifier: GPL-3.0-or-later
// Which boundary vertices to give up next, near where a try failed.
#pragma once

#include <vector>

#include "domain/layout.h"
#include "mesh/curved_mesh.h"

namespace c1mesh {

/// Makes up to `count` more boundary vertices exceptional, those nearest (in the shape) to the
/// vertices in `trouble`: joints that turn come first, reflex and mild ones before convex corners,
/// smooth vertices last. Returns how many were changed (0: none is left).
int demote_near(const CurvedMesh& mesh, const Joints& joints, const std::vector<int>& trouble,
                int count, Roles& roles);

/// Refines the mesh towards every corner that keeps C1: halves each edge of its fan, those on
/// curves too, `levels` times. The corner's forced gradient then rules a smaller place.
void grade_corners(CurvedMesh& mesh, const Joints& joints, const Roles& roles, int levels);

bool has_c1_corner(const Joints& joints, const Roles& roles);

/// Makes every corner, or every corner and mild joint, exceptional.
void demote_all_joints(const Joints& joints, Roles& roles);

}  // namespace c1mesh
