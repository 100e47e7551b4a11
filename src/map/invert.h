// SPDX-License-Identifier: GPL-3.0-or-later
// The inverse of one Bezier triangle.
#pragma once

#include <optional>

#include "bernstein/net_blossom.h"

namespace c1mesh {

/// Barycentric coordinates of a point of the Bezier triangle at x, to `tolerance` (> 0, lengths of
/// the net): found whenever x is in the triangle, or that far outside of one of its edges, where
/// they are negative by as much; none if x is farther than twice that from every point of it.
/// Exactly where x lies in between is up to rounding. Precondition: tolerance is well above the
/// rounding of the net's coordinates.
std::optional<Barycentric> invert(const Net& net, int degree, const Point& x, double tolerance);

}  // namespace c1mesh
