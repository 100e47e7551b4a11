// SPDX-License-Identifier: GPL-3.0-or-later
// The layer of disjoint warp triangles along the boundary: halves curves and lowers apexes until
// every warp triangle has its bound and none meets another (paper, section 4.1, and Mandad &
// Campen).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "mesh/initial_mesh.h"
#include "mesh/walks.h"
#include "mesh/warp_segment.h"

namespace c1mesh::meshing {

/// Called between pieces of work, if there is one; what it throws ends them.
using Stop = std::function<void()>;

/// What the mesher prefers where the shape is narrow: many triangles or flat ones. Angles in
/// radians.
struct Thrift {
  double base_angle;        ///< a warp triangle is halved rather than made flatter than this
  int patient_depth;        ///< true up to so many halvings of a curve; beyond,
  double impatience;        ///< the base angle and the margins fall by this factor per halving
  double least_angle;       ///< asked of the straight mesh outside warp triangles
  double least_warp_angle;  ///< and inside, where constraints leave less freedom
};
Thrift usual_thrift();
/// For shapes that would need far too many triangles otherwise.
Thrift strict_thrift();

/// Per walk, in its order, segments that are pairwise disjoint (hulls) but for the points that they
/// share; no two but twins share both ends. Fills splits, warp_triangles and notes of `report`.
/// Gives up and returns nothing if there are more than `limit` segments. Throws NoMesh if curves
/// cannot be told apart in double precision. `stop` is called now and then.
std::optional<std::vector<std::vector<WarpSegment>>> build_warp_layer(
    const Walks& walks, int degree, double mips_bound, const Thrift& thrift, std::size_t limit,
    MeshReport& report, const Stop& stop = {});

}  // namespace c1mesh::meshing
