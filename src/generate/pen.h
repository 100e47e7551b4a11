// SPDX-License-Identifier: GPL-3.0-or-later
// What the families draw with: closed loops through points with headings. Points lie on a grid, and
// where a loop is to be smooth its two handles are multiples of one grid vector: collinear exactly.
#pragma once

#include <vector>

#include "c1mesh/types.h"
#include "generate/portable_math.h"

namespace c1mesh::generate_detail {

using Curves = std::vector<BezierCurve>;

/// Of all coordinates: 2^-40, so that points below 2^10 and their differences are exact.
inline constexpr double kGrid = 1.0 / 1099511627776.0;

/// The nearest grid point.
Point snapped(const Point& p);

/// A place on a loop: the loop comes in along `in` and leaves along `out` (of any length). Equal
/// vectors make an exactly smooth joint; else both headings hold to about 1e-11.
struct Stop {
  Point at, in, out;
  bool line = false;  ///< a straight curve of degree 1 follows
};

/// A smooth stop.
inline Stop through(const Point& at, const Point& heading) {
  return {at, heading, heading};
}
/// A stop between two lines, or one where a line follows.
inline Stop corner(const Point& at) {
  return {at, Point::Zero(), Point::Zero(), true};
}

/// The closed loop through the stops; its cubics have the handles of circular arcs.
Curves closed_loop(const std::vector<Stop>& stops);

/// Straight curves of degree 1.
Curves polygon(const std::vector<Point>& points);

/// Quadratics from edge middle to edge middle with a vertex each as their inner pole: smooth
/// everywhere, exactly.
Curves rounded_polygon(const std::vector<Point>& points);

/// Four cubics, counter-clockwise or not.
Curves circle(const Point& centre, double radius, bool counter_clockwise);

void append(Curves& to, const Curves& more);

/// +90 degrees.
inline Point turned(const Point& v) {
  return {-v.y(), v.x()};
}

}  // namespace c1mesh::generate_detail
