// SPDX-License-Identifier: GPL-3.0-or-later
// Curves cut into pieces that turn little: the units of the intersection search.
#pragma once

#include <vector>

#include "check/arrangement.h"

namespace c1mesh::detail {

/// A range of angles (radians) around a direction: where the derivative of a piece points.
/// `low` and `high` are relative to `axis`; a cone narrower than pi is convex.
struct Cone {
  Point axis = Point::Zero();
  double low = 0, high = 0;

  double width() const { return high - low; }
};

/// A curve over [t0, t1] in the normalised frame.
struct Piece {
  int curve = -1;
  double t0 = 0, t1 = 1;
  std::vector<Point> poles;
  int node0 = -1, node1 = -1;  ///< equal numbers, equal end points; cuts have numbers of their own

  const Point& start() const { return poles.front(); }
  const Point& end() const { return poles.back(); }
};

using Poles2 = std::vector<Point>;

/// The cone of the differences of consecutive poles, which holds all derivatives. Zero differences
/// are passed over. Not convex (width >= pi) for poles that turn back.
Cone hodograph_cone(const Poles2& poles);

/// Do two convex cones share the direction zero only?
bool disjoint(const Cone& a, const Cone& b);

/// Both halves, by de Casteljau at 1/2; the shared point has the same bits in both.
void halve(const Poles2& poles, Poles2& first, Poles2& second);
void halve(const Piece& piece, Piece& first, Piece& second);

/// All pieces, ordered by curve and parameter; curve i's are first[i] … first[i + 1] - 1.
struct Pieces {
  std::vector<Piece> all;
  std::vector<int> first;
};

/// Cuts each curve until every piece's cone is narrower than 60 degrees, so that two neighbouring
/// pieces meet in their common end only. Curves that are not regular stay in one piece.
Pieces cut(const Arrangement& arrangement, const Nodes& nodes, const std::vector<char>& regular);

}  // namespace c1mesh::detail
