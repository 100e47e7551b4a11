// SPDX-License-Identifier: GPL-3.0-or-later
// Where two pieces meet.
#pragma once

#include <vector>

#include "check/pieces.h"

namespace c1mesh::detail {

/// A place where two pieces are closer than the resolution.
struct Meeting {
  int curve_a = -1, curve_b = -1;
  double t_a = 0, t_b = 0;
  Point where = Point::Zero();  ///< normalised frame
};

/// Every place (up to a few per pair) where the pieces come closer than the resolution, other than
/// the end points they have in common by node number. Bisection with separating-axis tests; pieces
/// flat to an eighth of the resolution are segments. Appends to `out`.
///
/// At a common end point P, pieces are followed outward from P until the cones of their derivatives
/// are disjoint: the points of a piece minus P lie in its cone, so they meet in P alone.
/// Halvings come off `effort`; nothing is sought once it is used up.
void find_meetings(const Piece& a, const Piece& b, std::vector<Meeting>& out, long& effort);

/// Halvings that all pairs together may take: curves that run side by side just farther apart than
/// the resolution take hundreds of thousands each.
inline constexpr long kMostEffort = 20'000'000;

/// Is `p` closer than the resolution to the piece?
bool near_piece(const Piece& piece, const Point& p);

}  // namespace c1mesh::detail
