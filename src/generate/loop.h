// SPDX-License-Identifier: GPL-3.0-or-later
// One random closed loop of cubics: a random tour, handles at its joints, and the tests it must
// pass.
#pragma once

#include <vector>

#include "c1mesh/types.h"
#include "generate/random.h"

namespace c1mesh::generate_detail {

/// Unit of all coordinates: 2^-6. Control points stay below 2^11 and so have at most 17 bits:
/// differences and cross products of them are exact in doubles.
inline constexpr double kUnit = 1.0 / 64;

/// Points at least a spacing apart in a disc of radius about 900, joined by a tour without
/// crossings, counter-clockwise. Multiples of kUnit.
std::vector<Point> random_tour(Random& random, int count);

/// Cubics through the tour's points. `corners[i]` says that joint i is not smooth; at the others
/// the handles are multiples of one vector on the grid, hence exactly collinear.
std::vector<BezierCurve> random_handles(Random& random, const std::vector<Point>& tour,
                                        const std::vector<bool>& corners);

/// Whether the loop keeps away from itself: points with distance s along the loop lie at least
/// min(clearance, s / 5) apart. That excludes crossings, cusps (interior angles below 23 degrees)
/// and necks. Also asks that no curve's speed falls far below its chord's length.
bool is_sound(const std::vector<BezierCurve>& loop, double clearance);

}  // namespace c1mesh::generate_detail
