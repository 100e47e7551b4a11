// SPDX-License-Identifier: GPL-3.0-or-later
// Exact answers about doubles: orientation, segment intersection, restriction of Bezier curves.
#pragma once

#include <gmpxx.h>

#include <vector>

#include "c1mesh/types.h"
#include "verify/bernstein_forms.h"

namespace c1mesh::verification {

using Rational = mpq_class;

Vec<Rational> exact(const Point& p);

/// Twice the signed area of (a, b, c).
Rational exact_area(const Vec<Rational>& a, const Vec<Rational>& b, const Vec<Rational>& c);

/// Sign of the area of (a, b, c): +1 counter-clockwise, 0 collinear, -1 clockwise. Exact.
int orientation(const Point& a, const Point& b, const Point& c);

/// Do the closed segments ab and cd have a point in common? Exact.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d);

/// Do the segments from p to a and from p to b overlap beyond p? Exact.
bool spokes_overlap(const Point& p, const Point& a, const Point& b);

/// The exact control points of `curve` restricted to t0 -> t1 and raised to `degree`.
/// Precondition: degree >= curve.degree().
std::vector<Vec<Rational>> exact_restriction(const BezierCurve& curve, double t0, double t1,
                                             int degree);

}  // namespace c1mesh::verification
