// SPDX-License-Identifier: GPL-3.0-or-later
// Which edges of the mesh lie on which input curve, with the triangle beside them.
#pragma once

#include <vector>

#include "write/piecewise_map.h"

namespace c1mesh {

/// An edge of the mesh on an input curve.
struct EdgeOnCurve {
  CurveEdge edge;
  bool feature = false;
  /// A triangle beside it and the corner where the triangle's side starts. The side runs from
  /// edge.a to edge.b, or from b to a if `against`: then no triangle lies on the left of a -> b.
  int triangle = -1, corner = -1;
  bool against = false;
};

/// Boundary edges and feature edges in the result's order; what is no edge of a triangle is left
/// out.
std::vector<EdgeOnCurve> edges_on_curves(const Result& result);

}  // namespace c1mesh
