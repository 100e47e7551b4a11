// SPDX-License-Identifier: GPL-3.0-or-later
// Where to give up C1: the fewest chain ends a loop needs, and candidates for the missing ones.
#pragma once

#include <vector>

#include "domain/layout.h"

namespace c1mesh {

/// A boundary vertex as (loop, position).
struct Place {
  int loop = 0, position = 0;
  bool operator==(const Place&) const = default;
};

/// How many chain ends of the right kind a loop still lacks: max(0, 3 - convex corners) for the
/// outer loop, max(0, 3 - reflex corners) for a hole, counting only C1 corners and exceptional
/// ends.
int missing_corners(const Joints& joints, const Roles& roles, int loop);

enum class Placement {
  curvature,  ///< where the boundary bends most over a twelfth of the loop, spaced apart
  tips,       ///< the same over a fiftieth: finds the ends of thin bands
  spread,     ///< evenly along the boundary, starting where it bends most
  shifted,    ///< evenly, offset by half a spacing
};

/// Roles with the missing corners of every loop, and of every cycle that bounds a face between
/// features, placed as exceptional vertices.
Roles place_exceptional(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                        Placement placement);

/// How many places give up C1; a branch point has one in each of its paths.
int count_exceptional(const Roles& roles);

/// The fewest exceptional vertices of the region (docs/vocabulary.md; joints decide, not roles).
int minimum_exceptional(const CurvedMesh& mesh, const Joints& joints);

/// Where one more exceptional vertex may lower the distortion: up to `count` positions per loop and
/// side at which the boundary bends most, apart from each other and from chain ends. Each is
/// `roles` with one flat or bent vertex changed: to exceptional where the domain's corner should be
/// convex (a limb's tip), to released where it should be free (a bay).
std::vector<Roles> one_more(const CurvedMesh& mesh, const Joints& joints, const Roles& roles,
                            int count);

}  // namespace c1mesh
