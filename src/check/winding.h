// SPDX-License-Identifier: GPL-3.0-or-later
// Winding numbers and areas of loops.
#pragma once

#include "check/pieces.h"

namespace c1mesh::detail {

/// How often the loop winds counter-clockwise around `p`, a point of the normalised frame farther
/// from the loop than the resolution: crossings of the ray to the right. Loops are closed bit for
/// bit and pieces share their ends' bits, so the half-open rule counts every crossing once.
int winding_number(const Loop& loop, const Pieces& pieces, const Point& p);

/// The signed area the loop encloses, in the normalised frame.
double signed_area(const Loop& loop, const Arrangement& arrangement);

}  // namespace c1mesh::detail
