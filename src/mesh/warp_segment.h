// SPDX-License-Identifier: GPL-3.0-or-later
// One piece of a boundary curve and the curved warp triangle that covers it (paper, section 4.1).
#pragma once

#include <vector>

#include "c1mesh/types.h"

namespace c1mesh::meshing {

/// A piece of a loop's curve over s in [s0, s1], with its warp triangle: corners start, end, apex;
/// the apex lies to the left. The warp map has the straight triangle (start, end, apex) as domain
/// and that triangle's net, with the base row replaced by the curve's poles, as control net.
struct WarpSegment {
  int loop = -1, source = -1;  ///< Walks[loop][source]
  int start = -1, end = -1;    ///< points; numbered by their first appearance as a start
  int twin = -1;               ///< the same piece of a feature from the other side (flat number)
  double s0 = 0, s1 = 1;       ///< dyadic, in the loop curve's own parameter
  int depth = 0;               ///< how often the curve was halved to get here
  BezierCurve curve;           ///< the piece, degree n
  bool straight = false;       ///< evenly spaced on its chord: the map is the identity, no apex
  double joint[2] = {0, 0};    ///< interior angle (radians, by tangents) at start and end
  double share[2] = {0, 0};    ///< the part of that angle the warp triangle may take
  double shrink = 1;           ///< the height's factor, lowered on conflict
  Point apex = Point::Zero();
  double height = 0;      ///< of the apex over the chord
  double base_angle = 0;  ///< the larger one of the triangle's two base angles, radians
  double bound = 0;       ///< g of the whole warp triangle (eq. 4.5)

  double length() const { return (curve.end() - curve.start()).norm(); }
};

/// Signed angle from u to v, counter-clockwise positive, in (-pi, pi].
double angle_between(const Point& u, const Point& v);

/// Directions of the curve where it starts and where it ends, never zero for a curve of any length.
Point start_direction(const BezierCurve& curve);
Point end_direction(const BezierCurve& curve);

/// Interior angle in (0, 2 pi] of a joint that is entered along `in` and left along `out`.
double interior_angle(const Point& in, const Point& out);

/// Are the poles evenly spaced on the chord, up to rounding?
bool is_straight(const BezierCurve& curve);

/// The warp triangle's net: degree n, corners start, end, apex.
std::vector<Point> warp_net(const WarpSegment& segment);

/// Places the apex from `joint`, `share` and `shrink` and fills height, base_angle and bound.
/// Returns false (bound infinite) if no triangle of a sensible base angle fits: split then.
bool place_apex(WarpSegment& segment);

/// How far the hull of the poles reaches beyond the tangent to the outside, in radians, at an end.
double outward_reach(const WarpSegment& segment, int end);

/// Convex hull of the poles and the apex, counter-clockwise; two points for a straight segment. The
/// straight and the curved warp triangle both lie in it.
std::vector<Point> hull_of(const WarpSegment& segment);

/// Is there a gap of more than `margin` >= 0 between two convex polygons, seen along one of their
/// edge normals? If so, their distance is more than `margin`; with margin 0: true exactly if
/// disjoint.
bool separated(const std::vector<Point>& a, const std::vector<Point>& b, double margin);

}  // namespace c1mesh::meshing
