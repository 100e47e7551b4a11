// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps the domain's boundary from crossing itself (after Jiang et al. 2017).
#pragma once

#include <vector>

#include "domain/energy.h"

namespace c1mesh {

enum class Flats {
  left_out,  ///< flat triangles that have no boundary edge for their base: nothing crosses when
             ///< they turn over, and chains that straighten must be let through
  kept,      ///< all but those that are flat to rounding
};

/// One element for each triangle of the plane around the domain (mesh/scaffold.h), each at its
/// optimum now: they keep the boundary from crossing itself for a few Newton steps. Empty where it
/// already does.
std::vector<DomainElement> scaffold_elements(const CurvedMesh& mesh, const PointMatrix& points,
                                             Flats flats, double weight);

/// Weight of a scaffold element for a mesh of so many triangles.
inline double scaffold_weight(int triangles) {
  return 0.1 / triangles;
}

/// Does the boundary cross or touch itself? Decided exactly.
bool boundary_meets_itself(const CurvedMesh& mesh, const PointMatrix& points);

}  // namespace c1mesh
