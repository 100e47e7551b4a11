// SPDX-License-Identifier: GPL-3.0-or-later
// From nearly C1 to C1, at the price of the boundary (paper, section 5.4).
#pragma once

#include "c1mesh/result.h"

namespace c1mesh {

/// A projected result and how far it moved.
struct Projection {
  Result result;            ///< same map but for its control points; metrics are not recomputed
  double before = 0;        ///< the largest residue of an equation, relative to the extent
  double after = 0;         ///< the same afterwards
  double largest_move = 0;  ///< of a control point, relative to the extent
  int singular = 0;         ///< domain vertices that were put onto the crossing of their edges
};

/// Projects all control points, those of the boundary too, orthogonally onto the space in which C1
/// holds across every edge that is not relaxed: p := (I - A^+ A) p, eq. (5.7). The domain stays,
/// but for nearly singular vertices (docs/paper.md), which are made singular where that saves
/// moves. The result claims C1 to rounding (`c1_bound`) and the boundary within
/// `conformance_bound`, and may have lost its regularity: verify it. Throws InputError
/// (unsupported) for a result whose domain has a triangle of no area.
Projection project(const Result& result, double conformance_bound = 1e-4);

}  // namespace c1mesh
