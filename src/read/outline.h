// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of one element in its own coordinates (y downward), and arcs as cubics.
#pragma once

#include <vector>

#include "c1mesh/types.h"
#include "read/transform.h"

namespace c1mesh::detail {

/// What a path or a basic shape draws: closed subpaths made of Bezier curves.
struct Outline {
  std::vector<std::vector<BezierCurve>> subpaths;  ///< each ends where it starts, bit for bit
  int arcs = 0;                                    ///< elliptical arcs that became cubics
  double arc_error = 0;                            ///< bound on their distance from the true arcs
  int closed_by_line = 0;                          ///< open subpaths that were closed for filling
  std::vector<char> closing_line;  ///< per subpath: is its last curve such a closing line?
};

/// Collects the curves of an outline, subpath by subpath.
class Pen {
 public:
  void move_to(const Point& p);
  void line_to(const Point& p);
  /// Degree = number of points given.
  void curve_to(std::vector<Point> rest);
  /// The SVG elliptical arc: radii, x-axis rotation in degrees, flags, end point
  /// (SVG 2, implementation notes B.2: radii that are too small are scaled up).
  void arc_to(Point radii, double rotation_degrees, bool large, bool sweep, const Point& end);
  /// Z: a line back to the start unless it is there already. The current point is the start.
  void close();
  const Point& at() const { return at_; }
  /// Ends the outline: an open last subpath is closed by a line and counted.
  Outline finish();

 private:
  void end_subpath(bool closed_by_author);

  Outline out_;
  std::vector<BezierCurve> current_;
  Point start_ = Point::Zero(), at_ = Point::Zero();
};

/// The largest distance of the usual cubic (handles 4/3 tan(angle/4)) from the unit circular arc of
/// `angle` radians.
double unit_arc_error(double angle);

}  // namespace c1mesh::detail
